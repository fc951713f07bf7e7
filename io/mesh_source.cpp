#include "io/mesh_source.h"

#include "io/chunked_mesh_source.h"
#include "io/error.h"
#include "io/ply_mesh_source.h"
#include "io/vtk_mesh_source.h"

namespace stream_recon {

std::unique_ptr<MeshSource> open_mesh_source(const MeshSourceOptions& options) {
  const std::string& path = options.path;
  if (path.ends_with(".pvtp") || path.ends_with(".vtp")) return open_chunked_mesh(path);
  if (path.ends_with(".ply") || path == "-") return open_ply_mesh(options);
  if (path.ends_with(".vtk")) return open_vtk_mesh(options);
  throw InputError(path + ": the name's ending is no mesh format; give .pvtp, .vtp, .ply or .vtk");
}

}  // namespace stream_recon
