// Is the compressed data of a MetaImage as long as its header says? ITK's reader fills what is
// missing with zeros and says nothing.
//
// Cost: the header is read, of the data only the length is looked up.
// Source: MetaIO's description of CompressedDataSize (Kitware, MetaIO/Documentation).
#pragma once

#include <string>

namespace stream_recon {

/// \throw InputError truncated
void check_metaimage_length(const std::string& path);

}  // namespace stream_recon
