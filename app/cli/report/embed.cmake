# cmake -D FOLDER=report -D CHARTS=FILE,FILE -D OUTPUT=page_parts.cpp -P embed.cmake
# Writes the parts of the page as the C++ source OUTPUT.
cmake_minimum_required(VERSION 3.22)

string(CONCAT source
  "// Written by embed.cmake from the files of app/report/.\n"
  "#include \"app/cli/report/page_parts.hpp\"\n\n"
  "// Longer than a compiler has to accept; those that build this do.\n"
  "#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\n"
  "namespace fixproof::cli {\n\nPageParts page_parts() {\n  PageParts parts;\n")

# part(NAME FILE...): the contents of the files, one after the other.
function(part name)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ ${FOLDER}/${file} contents)
    string(APPEND text "${contents}")
  endforeach()
  set(source "${source}  parts.${name} = R\"~page~(${text})~page~\";\n" PARENT_SCOPE)
endfunction()

part(page page.html)
part(style page.css)
part(d3 vendor/d3.min.js)
part(plot vendor/plot.umd.min.js)
string(REPLACE "," ";" charts "${CHARTS}")
part(charts ${charts})
file(WRITE ${OUTPUT} "${source}  return parts;\n}\n\n}  // namespace fixproof::cli\n")
