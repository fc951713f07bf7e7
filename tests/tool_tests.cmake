# The tests of the small programs: their libraries, and the programs as a user calls them.
if(NOT STREAM_RECON_TOOLS)
  return()
endif()

stream_recon_test(tool_clouds_test
  SOURCES tool_clouds_test.cpp
  LIBRARIES stream_recon_clouds)
stream_recon_test(tool_point_sink_test
  SOURCES tool_point_sink_test.cpp
  LIBRARIES stream_recon_points)
stream_recon_test(tool_radix_sort_test
  SOURCES tool_radix_sort_test.cpp
  LIBRARIES stream_recon_kernel_bench)

if(STREAM_RECON_CONVERTERS)
  stream_recon_test(tool_slices_test
    SOURCES tool_iso_points_test.cpp tool_itk_volume_test.cpp
    LIBRARIES stream_recon_slices)
endif()
