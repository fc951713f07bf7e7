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
stream_recon_test(tool_preview_test
  SOURCES tool_depth_buffer_test.cpp tool_preview_test.cpp
  LIBRARIES stream_recon_preview)
find_package(PNG REQUIRED)
target_link_libraries(tool_preview_test PRIVATE PNG::PNG)

stream_recon_test(tool_programs_test
  SOURCES tool_programs_test.cpp
  LIBRARIES stream_recon::io)
add_dependencies(tool_programs_test make-cloud bench-kernel mesh-preview)
target_compile_definitions(tool_programs_test PRIVATE
  STREAM_RECON_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")

if(STREAM_RECON_CONVERTERS)
  add_dependencies(tool_programs_test slices-to-points)
  target_compile_definitions(tool_programs_test PRIVATE STREAM_RECON_HAS_CONVERTERS)
  stream_recon_test(tool_slices_test
    SOURCES tool_dicom_test.cpp tool_image_stack_test.cpp tool_iso_points_test.cpp tool_raw_volume_test.cpp
      tool_slices_memory_test.cpp       tool_shared_volumes_test.cpp tool_volume_file_test.cpp
    LIBRARIES stream_recon_slices)
  find_package(JPEG REQUIRED)
  find_package(TIFF REQUIRED)
  target_link_libraries(tool_slices_test PRIVATE JPEG::JPEG PNG::PNG TIFF::TIFF ZLIB::ZLIB)
endif()
