#include "io/surface_writer.h"

#include <stdexcept>

#include "io/ply_writer.h"
#include "io/pvtp_writer.h"
#include "io/vtk_writer.h"

namespace stream_recon {

std::unique_ptr<SurfaceWriter> make_surface_writer(const SurfaceWriterOptions& options) {
  const std::string& path = options.path;
  if (path.ends_with(".pvtp")) return make_pvtp_writer(options);
  const bool is_ply = path == "-" || path.ends_with(".ply");
  if (!is_ply && !path.ends_with(".vtk")) {
    throw std::invalid_argument("cannot tell the format of '" + path +
                                "': name it .pvtp, .ply or .vtk, or - for standard output");
  }
  if (options.scratch == nullptr) {
    throw std::invalid_argument("writing '" + path + "' takes a scratch folder");
  }
  return is_ply ? make_ply_writer(options) : make_vtk_writer(options);
}

}  // namespace stream_recon
