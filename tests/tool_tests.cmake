# The tests of the small programs: their libraries, and the programs as a user calls them.
if(NOT STREAM_RECON_TOOLS)
  return()
endif()

stream_recon_test(tool_clouds_test
  SOURCES tool_clouds_test.cpp
  LIBRARIES stream_recon_clouds)
