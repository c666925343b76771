// SPDX-License-Identifier: MIT
// Assimp asks of every COLLADA file whether it is an archive (.zae). Here none is.
#include <assimp/ZipArchiveIOSystem.h>

namespace Assimp {

class ZipArchiveIOSystem::Implement {};

ZipArchiveIOSystem::ZipArchiveIOSystem(IOSystem*, const char*, const char*) {}
ZipArchiveIOSystem::ZipArchiveIOSystem(IOSystem*, const std::string&, const char*) {}
ZipArchiveIOSystem::~ZipArchiveIOSystem() = default;
bool ZipArchiveIOSystem::Exists(const char*) const { return false; }
char ZipArchiveIOSystem::getOsSeparator() const { return '/'; }
IOStream* ZipArchiveIOSystem::Open(const char*, const char*) { return nullptr; }
void ZipArchiveIOSystem::Close(IOStream*) {}
bool ZipArchiveIOSystem::isOpen() const { return false; }
void ZipArchiveIOSystem::getFileList(std::vector<std::string>&) const {}
void ZipArchiveIOSystem::getFileListExtension(std::vector<std::string>&, const std::string&) const {}
bool ZipArchiveIOSystem::isZipArchive(IOSystem*, const char*) { return false; }
bool ZipArchiveIOSystem::isZipArchive(IOSystem*, const std::string&) { return false; }

}  // namespace Assimp
