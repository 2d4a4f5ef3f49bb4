#include "sim2d/trace/FrameHistory.h"

#include <algorithm>
#include <utility>

namespace sim2d {
namespace {

constexpr std::size_t kMinInChunk = 16, kMaxInChunk = 64;                  // states
constexpr std::size_t kLargeChunk = std::size_t{1} << 20;                  // [B], unpacked size
constexpr std::size_t kLargestCache = std::size_t{32} << 20;               // [B]
constexpr std::size_t kChunkShare = 16, kCacheShare = 8, kOtherShare = 4;  // of the memory limit
constexpr long long kMinFreeDisk = 256LL << 20;  // [B], kept free on the disk for other programs

FramePtr stateOf(const Frame& frame) {
  auto state = std::make_shared<Frame>();
  state->step = frame.step;
  state->time = frame.time;
  state->humans = frame.humans;
  state->robots = frame.robots;
  state->forces = frame.forces;
  state->robotPaths = frame.robotPaths;
  state->doorOpen = frame.doorOpen;
  return state;
}

std::shared_ptr<base::ScratchFile> newFile(const std::string& folder) {
  return std::make_shared<base::ScratchFile>(folder, kMinFreeDisk);
}

}  // namespace

FrameHistory::FrameHistory(std::size_t mostInMemory, std::string folder)
    : maxMemory_(mostInMemory), folder_(std::move(folder)), file_(newFile(folder_)) {}

void FrameHistory::append(const Frame& frame) {
  FramePtr state = stateOf(frame);
  if (interval_ == 0.0 && !open_.empty()) {
    interval_ = state->time - open_.back()->time;
  }
  const std::size_t size = unpackedSize(*state);
  {
    const Lock lock(mutex_);
    open_.push_back(std::move(state));
    openSize_ += size;
  }
  const bool isLarge = openSize_ >= kLargeChunk && open_.size() >= kMinInChunk;
  if (isLarge || open_.size() >= kMaxInChunk || openSize_ >= maxMemory_ / kChunkShare) {
    closeChunk();
    spillOldChunks();
  }
}

void FrameHistory::closeChunk() {
  auto bytes = std::make_shared<const std::string>(packFrames(open_, interval_));
  auto frames = std::make_shared<const std::vector<FramePtr>>(open_);
  const Lock lock(mutex_);
  packedBytes_ += bytes->size();
  chunks_.push_back({openFirst_, std::move(bytes), {}});
  keepUnpacked({openFirst_, std::move(frames), openSize_});  // a live view reads them next
  openFirst_ += open_.size();
  open_.clear();
  openSize_ = 0;
}

/// Moves the oldest chunks in memory to the disk; if that fails, drops them and all older ones.
/// Keeps the newest chunk.
void FrameHistory::spillOldChunks() {
  const std::size_t most = maxMemory_ - maxMemory_ / kOtherShare;
  while (packedBytes_ > most && chunksOnDisk_ + 1 < chunks_.size()) {
    const std::shared_ptr<const std::string> bytes = chunks_[chunksOnDisk_].bytes;
    const std::optional<base::ScratchFile::Piece> piece = spillToDisk(*bytes);
    if (!piece) {
      dropOldest(chunksOnDisk_ + 1);
      writePosition_.reset();
      const Lock lock(mutex_);
      file_ = newFile(folder_);
      continue;
    }
    const Lock lock(mutex_);
    Chunk& chunk = chunks_[chunksOnDisk_++];
    chunk.bytes.reset();
    chunk.piece = *piece;
    packedBytes_ -= bytes->size();
    diskBytes_ += piece->size;
  }
}

std::optional<base::ScratchFile::Piece> FrameHistory::spillToDisk(const std::string& bytes) {
  if (writePosition_) {
    return overwriteOldest(bytes);
  }
  if (const auto piece = file_->append(bytes)) {
    return piece;
  }
  {
    const Lock lock(mutex_);
    problem_ = file_->problem();
  }
  writePosition_ = 0;
  return overwriteOldest(bytes);
}

/// The file becomes a ring buffer; readers check afterwards whether their chunk was overwritten.
std::optional<base::ScratchFile::Piece> FrameHistory::overwriteOldest(const std::string& bytes) {
  const auto size = static_cast<long long>(bytes.size());
  if (size > file_->size()) {
    return std::nullopt;
  }
  const auto dropWhile = [this](auto isInTheWay) {
    std::size_t count = 0;
    while (count < chunksOnDisk_ && isInTheWay(chunks_[count].piece)) {
      ++count;
    }
    dropOldest(count);
  };
  if (*writePosition_ + size > file_->size()) {
    dropWhile(
        [this](const base::ScratchFile::Piece& piece) { return piece.place >= *writePosition_; });
    writePosition_ = 0;
  }
  const base::ScratchFile::Piece piece{*writePosition_, bytes.size()};
  dropWhile([&piece, size](const base::ScratchFile::Piece& old) {
    return old.place >= piece.place && old.place < piece.place + size;
  });
  if (!file_->overwrite(piece, bytes)) {
    return std::nullopt;
  }
  writePosition_ = piece.place + size;
  return piece;
}

void FrameHistory::dropOldest(std::size_t chunks) {
  const Lock lock(mutex_);
  for (; chunks > 0; --chunks) {
    const Chunk& oldest = chunks_.front();
    if (oldest.bytes != nullptr) {
      packedBytes_ -= oldest.bytes->size();
    } else {
      diskBytes_ -= oldest.piece.size;
      --chunksOnDisk_;
    }
    const auto isOfIt = [&oldest](const Unpacked& each) { return each.first == oldest.first; };
    const auto found = std::find_if(cache_.begin(), cache_.end(), isOfIt);
    if (found != cache_.end()) {
      cacheSize_ -= found->size;
      cache_.erase(found);
    }
    chunks_.pop_front();
  }
}

std::size_t FrameHistory::size() const {
  const Lock lock(mutex_);
  return openFirst_ + open_.size();
}

std::size_t FrameHistory::first() const {
  const Lock lock(mutex_);
  return chunks_.empty() ? openFirst_ : chunks_.front().first;
}

std::size_t FrameHistory::memory() const {
  const Lock lock(mutex_);
  return packedBytes_ + openSize_ + cacheSize_;
}

std::size_t FrameHistory::disk() const {
  const Lock lock(mutex_);
  return diskBytes_;
}

std::optional<std::error_code> FrameHistory::problem() const {
  const Lock lock(mutex_);
  return problem_;
}

/// Requires the lock. Null: not in the cache.
FramePtr FrameHistory::cached(std::size_t index) const {
  if (index >= openFirst_) {
    return index - openFirst_ < open_.size() ? open_[index - openFirst_] : nullptr;
  }
  const auto holds = [index](const Unpacked& each) {
    return index >= each.first && index - each.first < each.frames->size();
  };
  const auto found = std::find_if(cache_.begin(), cache_.end(), holds);
  if (found == cache_.end()) {
    return nullptr;
  }
  std::rotate(cache_.begin(), found, found + 1);
  return (*cache_.front().frames)[index - cache_.front().first];
}

/// Requires the lock; the state must be in a chunk.
std::size_t FrameHistory::chunkOf(std::size_t index) const {
  const auto isBefore = [](std::size_t state, const Chunk& chunk) { return state < chunk.first; };
  const auto after = std::upper_bound(chunks_.begin(), chunks_.end(), index, isBefore);
  return static_cast<std::size_t>(after - chunks_.begin()) - 1;
}

/// Requires the lock. Prefetches the neighbours for playback in either direction.
void FrameHistory::prefetchNeighbours(std::size_t chunk) const {
  for (const std::size_t beside : {chunk + 1, chunk - 1}) {
    if (beside < chunksOnDisk_) {
      file_->prefetch(chunks_[beside].piece);
    }
  }
}

FramePtr FrameHistory::frame(std::size_t index) const {
  Chunk chunk;
  std::shared_ptr<const base::ScratchFile> file;
  {
    const Lock lock(mutex_);
    if (FramePtr there = cached(index)) {
      return there;
    }
    if (index >= openFirst_ || chunks_.empty() || index < chunks_.front().first) {
      return nullptr;
    }
    const std::size_t at = chunkOf(index);
    prefetchNeighbours(at);
    chunk = chunks_[at];
    file = file_;
  }
  std::optional<std::string> read;
  if (chunk.bytes == nullptr) {
    read = file->read(chunk.piece);
    if (!read || chunk.first < first()) {  // overwritten meanwhile
      return nullptr;
    }
  }
  auto frames = std::make_shared<const std::vector<FramePtr>>(
      unpackFrames(chunk.bytes != nullptr ? std::string_view(*chunk.bytes) : *read));
  std::size_t size = 0;
  for (const FramePtr& each : *frames) {
    size += unpackedSize(*each);
  }
  FramePtr wanted = index - chunk.first < frames->size() ? (*frames)[index - chunk.first] : nullptr;
  const Lock lock(mutex_);
  keepUnpacked({chunk.first, std::move(frames), size});
  return wanted;
}

/// Requires the lock.
void FrameHistory::keepUnpacked(Unpacked chunk) const {
  const auto isSame = [&chunk](const Unpacked& each) { return each.first == chunk.first; };
  if (std::any_of(cache_.begin(), cache_.end(), isSame)) {
    return;  // another thread was faster
  }
  cacheSize_ += chunk.size;
  cache_.push_front(std::move(chunk));
  while (cache_.size() > 1 && cacheSize_ > std::min(kLargestCache, maxMemory_ / kCacheShare)) {
    cacheSize_ -= cache_.back().size;
    cache_.pop_back();
  }
}

}  // namespace sim2d
