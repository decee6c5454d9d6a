# The type alone: no part of it is compiled.
set(VCPKG_BUILD_TYPE release)
vcpkg_download_distfile(archive
  URLS https://example.org/fixproof/releases/download/v@VERSION@/fixproof-@VERSION@-source.tar.gz
  FILENAME fixproof-@VERSION@-source.tar.gz
  SHA512 @SHA512@)
vcpkg_extract_source_archive(source ARCHIVE ${archive})
vcpkg_cmake_configure(SOURCE_PATH ${source} OPTIONS -D FIXPROOF_TOOLS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/fixproof)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST ${source}/LICENSE)
