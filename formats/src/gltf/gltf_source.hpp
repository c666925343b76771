// SPDX-License-Identifier: MIT
// A glTF document in memory with the map from its vertices to a Character's: what the reader keeps and the writer
// writes back.
#ifndef SINEW_FORMATS_GLTF_GLTF_SOURCE_HPP
#define SINEW_FORMATS_GLTF_GLTF_SOURCE_HPP

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gltf/gltf_model.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct DocumentForm;  // sinew_formats/document_form.hpp
struct Morphs;        // sinew_formats/morphs.hpp

using Json = nlohmann::json;  // not ordered_json, whose elements move when a key is added

// One primitive of one mesh node. A mesh that several nodes use has parts for each of them.
struct GltfPart {
  int node = -1;
  int primitive = -1;               // within the node's mesh
  std::vector<uint32_t> vertex_of;  // [vertices of the primitive] -> vertex of the Character
};

// tinygltf's own writer forgets what it does not know (empty arrays and objects inside extensions, extras of skins,
// names of samplers), which breaks VRM files. So the document is kept as JSON beside the parsed model, and the writer
// changes the JSON.
struct GltfSource {
  tinygltf::Model model;  // as read
  Json document;          // the same; all buffer views lie in buffer 0; pictures of other files stay in model.images
  std::vector<uint8_t> bytes;  // buffer 0
  std::vector<GltfPart> parts;
  std::vector<int> joint_nodes;  // [J] node of each joint
  GltfBindPose bind_pose;
  size_t vertex_count = 0;         // of the Character
  std::vector<Joint> joints;       // as read: a Character whose joints differ has its skeleton from elsewhere
  bool in_memory = false;          // that file is one of MemoryFiles
  std::string path;                // of the file that uris of pictures are relative to; empty when there is none
  std::vector<std::string> notes;  // one-line remarks for the user
};

// Parses a .gltf, .glb or .vrm file (or the bytes of one) with its buffers; compressed geometry is decoded, pictures are
// not. Parts and joints are left empty.
GltfSource load_gltf(const std::string& path, const std::vector<uint8_t>& file);

// Reads a document that was changed: everything but the model stays as it is in `changed`. Throws Error for a document that cannot be written.
std::shared_ptr<GltfSource> read_again(const std::string& name, GltfSource changed);

// Whether joints are still those of the file (`b`); one that had no parent there may have got one, see infer_parents().
bool same_joints(const std::vector<Joint>& a, const std::vector<Joint>& b);
// Returns whether joints begin with those of the file (`b`), in the sense of same_joints(), and all others are
// descendants of these.
bool has_joints(const std::vector<Joint>& a, const std::vector<Joint>& b);

// Where a Character's joints are in a document.
struct GltfJoints {
  std::vector<int> nodes;      // [J]
  std::vector<Affine> worlds;  // [J] in the pose that the weights are meant for
};
// Gives the document's mesh nodes the skin that `character` describes (its influences are not empty). Nodes whose
// vertices are all unbound, or which are children of a joint and follow it alone, are unchanged.
GltfJoints write_gltf_skin(const std::string& path, const Character& character, bool unorm8, GltfSource* source);
// Adds clips as animations of the joints, which are the motion's. Animations of the same name get a number.
void write_gltf_motion(const std::string& path, const Motion& motion, const GltfJoints& joints, GltfSource* source);
// Adds the character's joints as nodes and returns their numbers [J].
std::vector<int> add_joint_nodes(const std::string& path, const std::vector<Joint>& joints, Json* document);
// A document with one mesh node from a Character that has none of its own (an OBJ).
GltfSource gltf_from_mesh(const std::string& path, const Character& character);
// Pictures that are files beside the input, or data URIs, become parts of the buffer; those that were not found stay
// names. Without `files_too`, files stay files. Files of a kind that glTF does not embed keep their path, which is named
// from the folder of `path`.
void embed_images(const std::string& path, bool files_too, GltfSource* source);
// Appends bytes as a buffer view and an accessor on it; returns the accessor's number.
int add_accessor(GltfSource* source, const void* values, size_t size_bytes, const char* type, int component_type,
                 size_t count, bool vertex_attribute, bool normalized);
// Appends a vertex attribute of floats, `width` of 2 to 4 of them a vertex. With bounds, which positions need, least and greatest of each.
int add_vectors(GltfSource* source, const std::vector<float>& values, size_t width, bool with_bounds);
// Appends the times of keys, at least one, rising.
int add_key_times(GltfSource* source, const std::vector<float>& times);
// Removes the accessors of `candidates` and their buffer views and bytes where nothing else refers to them.
void drop_unused_accessors(std::vector<int> candidates, GltfSource* source);
// Removes one buffer view, not its bytes; false where something refers to it, or an extension may.
bool drop_unused_view(size_t view, Json* document);
// Removes an extension of the whole document, and its name from those used.
void drop_extension(const char* name, Json* document);
// Removes the skeleton that was read from a document whose meshes got another one: nodes of joints with their
// descendants unless they hold a mesh, a camera or a light, their animations, and what VRM's extensions and
// corrections say of joints. Nodes of `joints`, the new ones, and of the source's parts get their new numbers. A
// document with extensions that may name nodes keeps the nodes.
void drop_old_skeleton(GltfJoints* joints, GltfSource* source);

// Puts a document into another form: changes its nodes, skins, animations and extras; `joints` are its joints before, and are not changed. Returns remarks.
std::vector<std::string> put_into_form(const std::string& path, const DocumentForm& form, const GltfJoints& joints,
                                       GltfSource* source);

// Adds corrective shapes as morph targets of the meshes that they move, behind those that are there; drivers as `extras` of these meshes;
// clips as weights in the document's animations, of which the last ones are `new_animations`.
void add_gltf_morphs(const std::string& path, const Character& character, const Morphs& morphs,
                     const GltfJoints& joints, size_t new_animations, GltfSource* source);

// Values of an accessor for chosen vertices as a new accessor, in the kind of number that it has; floats of a sparse one.
//   read       the document as it was read, which `accessor` is of
//   vertices   which values, in their order; one may be there twice
//   all_stay   every value is among them: bounds stay those that the accessor has; else they are found
//   written    gets the new accessor
// Returns its number. Throws Error naming `where` for a vertex that has no value.
int pick_vertices(const std::string& where, const GltfSource& read, int accessor, const std::vector<uint32_t>& vertices,
                  bool all_stay, GltfSource* written);

}  // namespace sinew
#endif
