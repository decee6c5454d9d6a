# Builds and runs the consumer against fixed/: as a subfolder (WAY folder) or installed (WAY package).
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
set(compiler -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER})
if(WAY STREQUAL package)
  run(${CMAKE_COMMAND} -S ${ROOT}/fixed -B ${WORK}/fixed ${compiler}
    -DCMAKE_INSTALL_PREFIX=${WORK}/installed)
  run(${CMAKE_COMMAND} --install ${WORK}/fixed)
  set(where -DCMAKE_PREFIX_PATH=${WORK}/installed)
else()
  set(where -DFIXED_FOLDER=${ROOT}/fixed)
endif()
run(${CMAKE_COMMAND} -S ${ROOT}/tests/fixed/consumer -B ${WORK}/build ${compiler} ${where})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
