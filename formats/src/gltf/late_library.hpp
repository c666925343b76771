// SPDX-License-Identifier: MIT
// Shared libraries that few files need, loaded by the first of them: linked in, Assimp and Draco were half of every start of the command. The functions of
// theirs that readers call are defined in *_late.cpp under the names that the linker would bind, and hand on; no program or library
// exports these names.
#ifndef SINEW_FORMATS_GLTF_LATE_LIBRARY_HPP
#define SINEW_FORMATS_GLTF_LATE_LIBRARY_HPP

#include <dlfcn.h>

#include <string>

#include "sinew_formats/error.hpp"

namespace sinew {

class LateLibrary {
 public:
  //   file     what the dynamic linker looks for
  //   maker    who wrote it, for the error
  //   package  of Debian
  LateLibrary(const char* file, const char* maker, const char* package)
      : file_(file), maker_(maker), package_(package), handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {}
  LateLibrary(const LateLibrary&) = delete;  // it stays loaded
  LateLibrary& operator=(const LateLibrary&) = delete;

  // A member function is one whose first argument is the object. Throws Error where the library is not there, or is another one.
  template <class Result, class... Arguments>
  Result call(const char* name, Arguments... arguments) const {
    return reinterpret_cast<Result (*)(Arguments...)>(function(name))(arguments...);
  }

 private:
  void* function(const char* name) const {
    if (handle_ == nullptr)
      throw Error(std::string("this file needs ") + maker_ + ", whose library " + file_ +
                  " was not found; install it (Debian: " + package_ + "), or export as plain .glb");
    void* const found = dlsym(handle_, name);
    if (found == nullptr)
      throw Error(std::string(file_) + ": expected the " + maker_ + " that this sinew was built with, found no " +
                  name + " in it");
    return found;
  }

  const char *file_, *maker_, *package_;
  void* handle_;
};

}  // namespace sinew
#endif
