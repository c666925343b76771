# SPDX-License-Identifier: MIT
# The dock Sinew: the five steps of the page for the meshes that are selected in the open scene, each press one step of undo.
tool
extends VBoxContainer

const Skinning = preload("skinning.gd")
const STEPS = ["Mesh", "Skeleton", "Weights", "Motion", "Export"]  # those of the page (samples/web)

var plugin: EditorPlugin
var steps: TabContainer
var facts: Label
var rigid_parts: OptionButton
var softness: SpinBox
var all_bones: CheckBox
var symmetric: CheckBox
var message: Label


func _init() -> void:
	name = "Sinew"
	steps = TabContainer.new()
	steps.tab_align = TabContainer.ALIGN_LEFT
	for step in STEPS:
		var page = VBoxContainer.new()
		page.name = step
		steps.add_child(page)
	add_child(steps)
	facts = said("Mesh", "Select the meshes of a character.")
	said("Skeleton", "A skeleton for the selected meshes, which are bound to it.")
	button("Skeleton", "New skeleton", "Make a skeleton for the selected meshes, and bind them to it", "rig")
	said("Weights", "Weights of the selected meshes for their skeleton.")
	button("Weights", "Bind", "Predict weights of the selected meshes for their skeleton, or for a selected Skeleton", "bind")
	rigid_parts = OptionButton.new()
	for text in ["auto", "always", "never"]:
		rigid_parts.add_item(text)
	row("Rigid parts", rigid_parts, "always: every connected part moves with one bone, as in robots and toys")
	softness = SpinBox.new()
	softness.min_value = 0.25
	softness.max_value = 4
	softness.step = 0.05
	softness.value = 1
	row("Soft", softness, "How softly weights blend between bones: 2 twice as softly, 0.5 harder")
	symmetric = CheckBox.new()
	row("Symmetric weights", symmetric, "Both sides get mirrored weights")
	all_bones = CheckBox.new()
	row("All bones", all_bones, "Every bone may get weight; else those that have some, or by their names those that deform")
	said("Motion", "A file that is imported as Sinew Character can have a motion: Import > Motion.")
	said("Export", "The scene is the character; it is saved with it.")
	message = Label.new()
	message.autowrap = true
	add_child(message)


func page(step: String) -> Node:
	return steps.get_child(STEPS.find(step))


# A sentence of a step.
func said(step: String, text: String) -> Label:
	var label = Label.new()
	label.text = text
	label.autowrap = true
	page(step).add_child(label)
	return label


func show_selected() -> void:
	show_meshes(selected(MeshInstance))


# Says what is selected, and opens the first step that is still to do.
func show_meshes(instances: Array) -> void:
	var vertices = 0
	var bound = not instances.empty()
	var rigged = not instances.empty()
	for instance in instances:
		vertices += Skinning.vertex_count(instance.mesh)
		bound = bound and instance.skin != null
		rigged = rigged and skeleton_of(instance) != null
	facts.text = "Select the meshes of a character." if instances.empty() else "%d vertices in %d meshes." % [vertices, instances.size()]
	steps.current_tab = STEPS.find("Mesh" if instances.empty() else "Skeleton" if not rigged else "Weights" if not bound else "Motion")


func button(step: String, text: String, hint: String, method: String) -> void:
	var made = Button.new()
	made.text = text
	made.hint_tooltip = hint
	made.connect("pressed", self, method)
	page(step).add_child(made)


func row(text: String, control: Control, hint: String) -> void:
	var line = HBoxContainer.new()
	var label = Label.new()
	label.text = text
	label.size_flags_horizontal = SIZE_EXPAND_FILL
	control.hint_tooltip = hint
	line.add_child(label)
	line.add_child(control)
	page("Weights").add_child(line)


func selected(type) -> Array:
	var found = []
	for node in plugin.get_editor_interface().get_selection().get_selected_nodes():
		if node is type and (not node is MeshInstance or node.mesh != null):
			found.append(node)
	return found


func say(text: String):
	message.text = text
	if text.begins_with("sinew: error: "):
		push_error(text)


func options() -> Array:
	return ["--rigid-parts", rigid_parts.get_item_text(rigid_parts.selected), "--softness", softness.value]


# The skeleton of a mesh: that of its property, else the next one above it.
static func skeleton_of(instance: MeshInstance) -> Skeleton:
	if not instance.skeleton.is_empty() and instance.get_node_or_null(instance.skeleton) is Skeleton:
		return instance.get_node(instance.skeleton) as Skeleton
	var node = instance.get_parent()
	while node != null and not node is Skeleton:
		node = node.get_parent()
	return node as Skeleton


func bind():
	var instances = selected(MeshInstance)
	var skeletons = selected(Skeleton)
	if instances.empty():
		return say("sinew: error: no mesh is selected; select MeshInstances, and a Skeleton where they have none")
	var skeleton = skeletons[0] if skeletons.size() == 1 else skeleton_of(instances[0])
	if skeleton == null:
		return say("sinew: error: %s has no skeleton; select one beside it, or press New skeleton" % instances[0].name)
	for instance in instances:
		if skeletons.empty() and skeleton_of(instance) != skeleton:
			return say("sinew: error: %s and %s have different skeletons; bind them apart" % [instances[0].name, instance.name])
	var extra = options()
	if symmetric.pressed:
		extra.append("--symmetric")
	if all_bones.pressed:
		extra += ["--joints", "all"]
	finish("Bind", Skinning.bind(instances, skeleton, extra), null)


func rig():
	var instances = selected(MeshInstance)
	if instances.empty():
		return say("sinew: error: no mesh is selected; select MeshInstances")
	var root = plugin.get_editor_interface().get_edited_scene_root()
	var parent = instances[0] if instances[0] == root else instances[0].get_parent()
	finish("Rig", Skinning.rig(instances, parent, options() + (["--mirror"] if symmetric.pressed else [])), parent)


func finish(name: String, answer: Dictionary, parent: Node):
	if answer.error != "":
		return say(answer.error)
	Skinning.commit(plugin.get_undo_redo(), "Sinew: %s" % name, answer, parent, plugin.get_editor_interface().get_edited_scene_root())
	say("%s: %d meshes" % [name, answer.changes.size()])
