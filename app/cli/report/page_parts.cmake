# Builds the files of app/report/ into the program.
set(page_folder ${PROJECT_SOURCE_DIR}/app/report)
set(page_charts base verification trade errors drift stepping scenes claims main)
list(TRANSFORM page_charts REPLACE "(.+)" "charts/\\1.js")
set(page_files page.html page.css vendor/d3.min.js vendor/plot.umd.min.js ${page_charts})
list(TRANSFORM page_files PREPEND ${page_folder}/)
list(JOIN page_charts "," page_charts)
set(page_source ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp)
add_custom_command(OUTPUT ${page_source}
  COMMAND ${CMAKE_COMMAND} -D FOLDER=${page_folder} -D CHARTS=${page_charts} -D OUTPUT=${page_source}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/report/embed.cmake
  DEPENDS ${page_files} report/embed.cmake
  COMMENT "Embedding the page of the report" VERBATIM)
target_sources(fixproof_cli PRIVATE ${page_source})
set_source_files_properties(${page_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
