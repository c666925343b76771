# SPDX-License-Identifier: MIT
# UNTESTED: no vcpkg was at hand. The engine alone; fill in REF and SHA512 of the release's archive.
vcpkg_from_github(OUT_SOURCE_PATH SOURCE_PATH REPO sinew/sinew REF "v${VERSION}" SHA512 0 HEAD_REF main)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}/engine")
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/sinew)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
