#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "sim2d/base/Files.h"
#include "sim2d/trace/Frame.h"

namespace sim2d {

using FramePtr = std::shared_ptr<const Frame>;

/// Lossless compression of consecutive states: columns of bodies, forces, paths and doors; no
/// events, inputs, tree changes, senses, scans. Numbers are stored as the difference to a
/// prediction from the previous state, without leading zeros (as in FPC: Burtscher, Ratanaworabhan,
/// "FPC: A High-Speed Compressor for Double-Precision Floating-Point Data", IEEE Trans. Computers
/// 58, 2009, with body motion as the predictor). `interval`: usual time between states [s]; other
/// intervals only need more space. The format is private to the process. Thread-safe.
std::string packFrames(const std::vector<FramePtr>& frames, double interval);
/// Restores the states; truncated input gives empty states.
std::vector<FramePtr> unpackFrames(std::string_view bytes);
/// Unpacked size [bytes].
std::size_t unpackedSize(const Frame& frame);

/// States of a run with bounded memory. States are packed in chunks: the newest are in memory,
/// older ones in an unnamed temporary file. When the disk is full, the oldest chunks are dropped;
/// the kept states are contiguous up to the newest. One thread appends, any thread may read; only
/// threads that read from disk or append wait for it.
class FrameHistory {
 public:
  /// `mostInMemory` [B] limits packed, unpacked and cached states together; one chunk is always
  /// kept. `folder`: of the temporary file; empty: see ScratchFile.
  explicit FrameHistory(std::size_t mostInMemory, std::string folder = {});
  ~FrameHistory() = default;
  FrameHistory(const FrameHistory&) = delete;
  FrameHistory& operator=(const FrameHistory&) = delete;
  FrameHistory(FrameHistory&&) = delete;
  FrameHistory& operator=(FrameHistory&&) = delete;

  /// Stores the state only: no events, inputs, tree changes, senses, scans.
  void append(const Frame& frame);

  // thread-safe
  std::size_t size() const;   // number of appended states
  std::size_t first() const;  // oldest state kept
  /// Null: dropped, or the file cannot be read.
  FramePtr frame(std::size_t index) const;
  std::size_t memory() const;  // [B]
  std::size_t disk() const;    // [B]
  /// The error of the disk, if a write failed.
  std::optional<std::error_code> problem() const;

 private:
  struct Chunk {
    std::size_t first = 0;                     // index of a state
    std::shared_ptr<const std::string> bytes;  // null: on disk
    base::ScratchFile::Piece piece;
  };
  struct Unpacked {
    std::size_t first = 0;
    std::shared_ptr<const std::vector<FramePtr>> frames;
    std::size_t size = 0;  // [B]
  };
  using Lock = std::lock_guard<std::mutex>;

  void closeChunk();
  void spillOldChunks();
  std::optional<base::ScratchFile::Piece> spillToDisk(const std::string& bytes);
  std::optional<base::ScratchFile::Piece> overwriteOldest(const std::string& bytes);
  void dropOldest(std::size_t chunks);
  FramePtr cached(std::size_t index) const;
  std::size_t chunkOf(std::size_t index) const;
  void prefetchNeighbours(std::size_t chunk) const;
  void keepUnpacked(Unpacked chunk) const;

  const std::size_t maxMemory_;  // [B], total limit
  mutable std::mutex mutex_;
  std::deque<Chunk> chunks_;      // those on disk first
  std::size_t chunksOnDisk_ = 0;  // number of chunks on disk
  std::size_t packedBytes_ = 0;   // [B] in memory
  std::size_t diskBytes_ = 0;     // [B] of chunks in the file
  std::vector<FramePtr> open_;
  std::size_t openFirst_ = 0, openSize_ = 0;
  mutable std::deque<Unpacked> cache_;  // most recently used first
  mutable std::size_t cacheSize_ = 0;
  std::optional<std::error_code> problem_;
  // used by the appending thread only
  const std::string folder_;
  std::shared_ptr<base::ScratchFile> file_;  // shared with readers
  std::optional<long long> writePosition_;   // write position in the ring; none: the file grows
  double interval_ = 0.0;                    // [s] between states
};

}  // namespace sim2d
