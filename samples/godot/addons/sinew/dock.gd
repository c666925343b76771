# SPDX-License-Identifier: MIT
# The dock Sinew: a skeleton and weights for the meshes that are selected in the open scene, each press one step of undo.
tool
extends VBoxContainer

const Skinning = preload("skinning.gd")

var plugin: EditorPlugin
var rigid_parts: OptionButton
var softness: SpinBox
var all_bones: CheckBox
var symmetric: CheckBox
var message: Label


func _init() -> void:
	name = "Sinew"
	button("New skeleton", "Make a skeleton for the selected meshes and bind them to it", "rig")
	button("Bind", "Predict weights of the selected meshes for their skeleton, or for a selected Skeleton", "bind")
	rigid_parts = OptionButton.new()
	for text in ["auto", "always", "never"]:
		rigid_parts.add_item(text)
	row("Rigid parts", rigid_parts, "always: each connected part moves with one bone, as in robots and toys")
	softness = SpinBox.new()
	softness.min_value = 0.25
	softness.max_value = 4
	softness.step = 0.05
	softness.value = 1
	row("Soft", softness, "Softness of the blend between bones: 2 twice as soft, 0.5 half as soft")
	symmetric = CheckBox.new()
	row("Symmetric weights", symmetric, "Give both sides mirrored weights")
	all_bones = CheckBox.new()
	row("All bones", all_bones, "Let every bone get weight; by default those that already have some, or those that deform by their names")
	message = Label.new()
	message.autowrap = true
	add_child(message)


func button(text: String, hint: String, method: String) -> void:
	var made = Button.new()
	made.text = text
	made.hint_tooltip = hint
	made.connect("pressed", self, method)
	add_child(made)


func row(text: String, control: Control, hint: String) -> void:
	var line = HBoxContainer.new()
	var label = Label.new()
	label.text = text
	label.size_flags_horizontal = SIZE_EXPAND_FILL
	control.hint_tooltip = hint
	line.add_child(label)
	line.add_child(control)
	add_child(line)


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


func bind():
	var instances = selected(MeshInstance)
	var skeletons = selected(Skeleton)
	if instances.empty():
		return say("sinew: error: no mesh is selected; select MeshInstances, and a Skeleton if they have none")
	var skeleton = skeletons[0] if skeletons.size() == 1 else Skinning.skeleton_of(instances[0])
	if skeleton == null:
		return say("sinew: error: %s has no skeleton; select one beside it, or press New skeleton" % instances[0].name)
	for instance in instances:
		if skeletons.empty() and Skinning.skeleton_of(instance) != skeleton:
			return say("sinew: error: %s and %s have different skeletons; bind them separately" % [instances[0].name, instance.name])
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
