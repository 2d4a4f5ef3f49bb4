#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "sim2d/base/Files.h"
#include "sim2d/trace/FramePacking.h"

namespace sim2d {

/// The states of a run within a limit of memory. They are packed in chunks; the newest chunks stay
/// in memory, older ones lie in a temporary file without a name. When the disk takes no more, the
/// oldest are dropped for new ones: what is kept is always without a gap, up to the newest. One
/// thread appends, any others read; nobody waits for the disk but who reads from it or appends.
class FrameHistory {
 public:
  /// `mostInMemory` [B] holds packed states, those being packed, and those unpacked to be read; a
  /// chunk is kept whatever the limit. `folder`: of the temporary file; empty: ScratchFile's.
  explicit FrameHistory(std::size_t mostInMemory, std::string folder = {});
  ~FrameHistory() = default;
  FrameHistory(const FrameHistory&) = delete;
  FrameHistory& operator=(const FrameHistory&) = delete;
  FrameHistory(FrameHistory&&) = delete;
  FrameHistory& operator=(FrameHistory&&) = delete;

  /// Its state alone: no events, inputs, tree changes, senses, scans.
  void append(const Frame& frame);

  // any thread
  std::size_t size() const;   // that were appended
  std::size_t first() const;  // the oldest that is kept
  /// Null: dropped meanwhile, or the file cannot be read.
  FramePtr frame(std::size_t index) const;
  std::size_t memory() const;  // [B]
  std::size_t disk() const;    // [B]
  /// Why the disk took no more, if that has happened.
  std::optional<std::error_code> problem() const;

 private:
  struct Chunk {
    std::size_t first = 0;                     // state
    std::shared_ptr<const std::string> bytes;  // null: in the file
    base::ScratchFile::Piece piece;
  };
  struct Unpacked {
    std::size_t first = 0;
    std::shared_ptr<const std::vector<FramePtr>> frames;
    std::size_t size = 0;  // [B]
  };
  using Lock = std::lock_guard<std::mutex>;

  void closeChunk();
  void makeRoom();
  std::optional<base::ScratchFile::Piece> putAside(const std::string& bytes);
  std::optional<base::ScratchFile::Piece> putOverOldest(const std::string& bytes);
  void dropOldest(std::size_t chunks);
  FramePtr cached(std::size_t index) const;
  std::size_t chunkOf(std::size_t index) const;
  void announceBeside(std::size_t chunk) const;
  void keepUnpacked(Unpacked chunk) const;

  const std::size_t most_;  // [B], all
  mutable std::mutex mutex_;
  std::deque<Chunk> chunks_;  // of the file, then of the memory
  std::size_t inFile_ = 0;    // chunks
  std::size_t packed_ = 0;    // [B] in memory
  std::size_t disk_ = 0;      // [B] of chunks in the file
  std::vector<FramePtr> open_;
  std::size_t openFirst_ = 0, openSize_ = 0;
  mutable std::deque<Unpacked> cache_;  // read last first
  mutable std::size_t cacheSize_ = 0;
  std::optional<std::error_code> problem_;
  // of the thread that appends
  const std::string folder_;
  std::shared_ptr<base::ScratchFile> file_;  // readers hold it while they read
  std::optional<long long> next_;            // where the file is written over; none: it grows
  double interval_ = 0.0;                    // [s] between two states
};

}  // namespace sim2d
