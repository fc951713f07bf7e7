#include <map>

#include "tools/convert/command_line.h"

namespace stream_recon {
namespace {

void add_input_options(CLI::App& app, ConverterCommand& line) {
  app.add_option("INPUT", line.volume.paths,
                 "A volume (NIfTI, NRRD, MetaImage, multi-page TIFF, DICOM), a folder of slices "
                 "(DICOM, PNG, TIFF, JPEG, BMP), or slices in their order")
      ->required();
  app.add_option("--spacing", line.spacing,
                 "Distance of neighbouring voxels along i, j, k, instead of the file's")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z");
  app.add_option("--series", line.volume.series,
                 "DICOM: the series, by its UID, the UID's ending or its number from 1")
      ->option_text("ID");
  app.add_option("--dims", line.dims, "Raw voxels without a header: voxels along i, j, k")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z");
  const std::map<std::string, RawType> types{
      {"u8", RawType::kUint8},    {"i8", RawType::kInt8},    {"u16", RawType::kUint16},
      {"i16", RawType::kInt16},   {"u32", RawType::kUint32}, {"i32", RawType::kInt32},
      {"f32", RawType::kFloat32}, {"f64", RawType::kFloat64}};
  app.add_option("--type", line.raw_type, "Raw: u8 (default), i8, u16, i16, u32, i32, f32 or f64")
      ->transform(CLI::CheckedTransformer(types))
      ->needs("--dims")
      ->option_text("TYPE");
  app.add_flag("--big-endian", line.big_endian, "Raw: most significant byte first")
      ->needs("--dims");
  app.add_option("--skip", line.skip, "Raw: bytes before the first voxel of each file")
      ->needs("--dims")
      ->option_text("BYTES");
}

void add_selection_options(CLI::App& app, ConverterCommand& line) {
  app.add_option("--iso", line.iso, "Points where grid edges cross this value")->option_text("V");
  app.add_option("--label", line.label,
                 "The boundary of a label, of several as one (3,4,7), of any, or of each, a file "
                 "for every label")
      ->option_text("LABELS");
  app.add_option("--above", line.above, "The boundary of the voxels above this value")
      ->option_text("V");
  app.add_option("--at-least", line.at_least, "The boundary of the voxels of this value and more")
      ->option_text("V");
  app.add_flag("--boundary-voxels", line.boundary_voxels,
               "Centres of object voxels that have a face neighbour outside, instead of points on "
               "the smoothed boundary");
  app.add_option("--smooth", line.smooth,
                 "Standard deviation of the smoothing, voxels (default: 1 for objects, 0, that is "
                 "none, for --iso)")
      ->check(CLI::Range(0.0, 20.0))
      ->option_text("S");
  app.add_flag("--keep-thin", line.keep_thin,
               "Objects: smoothing moves no voxel to the other side, so that nothing thin is lost "
               "(what is thinner than 1.35 S is otherwise); the points make rougher surfaces");
}

void add_grid_options(CLI::App& app, ConverterCommand& line) {
  app.add_option("--roi", line.roi, "Only these voxels, each range without its end: 10:200,:,5:40")
      ->option_text("I:I,J:J,K:K");
  app.add_option("--every", line.every, "Only every n-th voxel: one number, or one for i, j, k")
      ->delimiter(',')
      ->expected(1, 3)
      ->option_text("N");
  app.add_option("--align", line.align,
                 "File that says how far slices must be moved: lines \"slice di dj\", in voxels")
      ->option_text("FILE");
  const std::map<std::string, CoordinateSystem> systems{{"world", CoordinateSystem::kWorld},
                                                        {"index", CoordinateSystem::kIndex}};
  app.add_option("--coordinates", line.coordinates,
                 "world (default: spacing, origin and direction apply) or index (voxel numbers)")
      ->transform(CLI::CheckedTransformer(systems))
      ->option_text("KIND");
}

void add_output_options(CLI::App& app, ConverterCommand& line) {
  app.add_option("-o,--output", line.output.path, "File, or - for standard output")
      ->required()
      ->option_text("OUT");
  const std::map<std::string, Scalar> scalars{{"float", Scalar::kFloat32},
                                              {"double", Scalar::kFloat64}};
  app.add_option("--scalar", line.output.scalar,
                 "Coordinates of ply and pts: float (default) or double")
      ->transform(CLI::CheckedTransformer(scalars))
      ->option_text("TYPE");
  const std::map<std::string, PointFormat> formats{{"ply", PointFormat::kPly},
                                                   {"xyz", PointFormat::kXyz},
                                                   {"f32", PointFormat::kF32},
                                                   {"f64", PointFormat::kF64},
                                                   {"pts", PointFormat::kPts}};
  app.add_option("--output-format", line.format,
                 "ply, xyz, f32, f64 or pts (default: by the name's ending, else ply; for - pts, "
                 "which stream-recon - understands)")
      ->transform(CLI::CheckedTransformer(formats))
      ->option_text("FORMAT");
}

}  // namespace

void add_converter_options(CLI::App& app, ConverterCommand& command) {
  add_input_options(app, command);
  add_selection_options(app, command);
  add_grid_options(app, command);
  add_output_options(app, command);
}

}  // namespace stream_recon
