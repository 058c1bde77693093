// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/arena.h"

#include <algorithm>

namespace latchwork::pttp {

Word* Arena::AllocateInNextChunk(std::size_t words) {
  const std::size_t next = chunks_.empty() ? 0 : chunk_ + 1;
  if (next >= chunks_.size() || chunks_[next].size() < words) {
    const std::size_t doubled = kFirstChunk << std::min<std::size_t>(next, 8);
    const std::size_t size = std::max(words, std::min(doubled, kLargestChunk));
    chunks_.emplace(chunks_.begin() + static_cast<std::ptrdiff_t>(next), size);
    reserved_ += size;
  }
  chunk_ = next;
  used_ = words;
  return chunks_[next].data();
}

}  // namespace latchwork::pttp
