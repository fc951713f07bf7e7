// Which artefacts of a killed run are there, whole.
//
// Thread rule: one thread. Memory: two blocks and a codec. Cost: one pass over all artefacts.
#pragma once

#include <string>
#include <vector>

#include "engine/restart/manifest.h"
#include "io/scratch_directory.h"

namespace stream_recon {

/// Takes out of the manifest what is damaged or lacking, and what was made from it; removes all
/// files that the rest does not name. \return For a person, what has to be done again; empty where
/// all is well. \throw IoError the folder cannot be listed
std::string keep_intact_artefacts(Manifest& manifest, ScratchDirectory& scratch);

}  // namespace stream_recon
