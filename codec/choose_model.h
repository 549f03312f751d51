// Which model suits the letters of a mesh, by trying.
#ifndef CLERS_CODEC_CHOOSE_MODEL_H
#define CLERS_CODEC_CHOOSE_MODEL_H

#include <cstdint>
#include <vector>

#include "codec/letter_model.h"

namespace clers {

/// The model of a level that codes these letters (Record::contexts) in the fewest bits, as far as a
/// sample tells. Throws std::bad_alloc only. Cost: at most 2^15 letters, three times.
LetterModel choose_model(const std::vector<std::uint8_t>& contexts, int level);

}  // namespace clers

#endif
