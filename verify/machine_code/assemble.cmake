# cmake -D WRITE_SOURCES=… -D NASM=… -D FRAMES=… -D FOLDER=… -D TABLE=… -P assemble.cmake
# Runs WRITE_SOURCES to write the sources of all programs into FOLDER, assembles them with NASM and
# writes the bytes to the C++ source TABLE. A NAME.com.asm is a DOS command in the frame of FRAMES.
cmake_minimum_required(VERSION 3.22)

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${WRITE_SOURCES} ${FOLDER}
  OUTPUT_VARIABLE names OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" names "${names}")

# bytes_of(FILE VARIABLE): assembles FILE.asm and sets VARIABLE to its bytes as C++ literals.
function(bytes_of file variable)
  execute_process(
    COMMAND ${NASM} -w+all -w+error -f bin -I ${FRAMES}/ -o ${FOLDER}/${file}.bin ${FOLDER}/${file}.asm
    COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${FOLDER}/${file}.bin bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  set(${variable} "${bytes}" PARENT_SCOPE)
endfunction()

set(arrays "")
set(entries "")
set(number 0)
foreach(name IN LISTS names)
  bytes_of(${name} alone)
  string(APPEND arrays "constexpr std::uint8_t alone_${number}[] = {${alone}};\n")
  set(command_bytes "{}")
  if(EXISTS ${FOLDER}/${name}.com.asm)
    bytes_of(${name}.com command)
    string(APPEND arrays "constexpr std::uint8_t command_${number}[] = {${command}};\n")
    set(command_bytes command_${number})
  endif()
  string(APPEND entries "    {\"${name}\", alone_${number}, ${command_bytes}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${TABLE}
  "// Written by assemble.cmake from the model's programs.\n"
  "#include \"verify/machine_code/table.hpp\"\n\n"
  "namespace fixproof::machine_code {\nnamespace {\n\n${arrays}\n"
  "constexpr Assembled entries[] = {\n${entries}};\n\n}  // namespace\n\n"
  "std::span<const Assembled> assembled_programs() { return entries; }\n\n}  // namespace fixproof::machine_code\n")
