#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/costmap/InflationLaw.h"

namespace sim2d::nav2 {

/// Costs round lethal cells (nav2_costmap_2d::InflationLayer). Humble and Jazzy spread over the
/// four neighbours in order of distance, so now and then a cell takes a source that is not quite
/// the nearest; main has the exact distance, in steps of 1/100 cell.
class InflationLayer : public CostmapLayer {
 public:
  InflationLayer(std::string name, const CostmapContext& context,
                 const InflationLayerParameters& parameters, double resolution);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_; }

  const InflationLaw& law() const { return law_; }

 private:
  struct Spread {  // a cell and the lethal one that its cost is from
    Cell cell, source;
  };
  bool isSource(std::uint8_t cost) const;
  std::uint8_t raised(std::uint8_t old, std::uint8_t cost) const;
  void inflateBySpreading(Costmap& master, const CellWindow& window, const CellWindow& wide);
  void beginSeen(const Costmap& master);
  std::size_t seenIndex(Cell cell) const {
    return static_cast<std::size_t>(cell.row + 1) * seenWidth_ +
           static_cast<std::size_t>(cell.column + 1);
  }
  void enqueue(const Spread& spread, std::size_t bin);
  template <class Square>
  void inflateExactly(Costmap& master, const CellWindow& window, const CellWindow& wide,
                      std::vector<Square>& across);
  template <class Square>
  void findRowDistances(const Costmap& master, const CellWindow& window, const CellWindow& wide,
                        std::vector<Square>& across) const;

  InflationLayerParameters parameters_;
  InflationLaw law_;
  int radius_ = 0;  // [cells]
  bool isWhole_ = true, isCurrent_ = true;
  CostmapBounds last_;
  std::vector<std::uint8_t> costs_;        // by squared distance [cells²], up to radius_²
  std::vector<std::vector<Spread>> bins_;  // idem; empty between updates
  std::vector<char> seen_;                 // cells, with a border of one that is seen
  std::size_t seenWidth_ = 0;
  std::vector<std::int16_t> across_;     // squared distances along rows [cells²]
  std::vector<std::int32_t> acrossFar_;  // idem, of a large radius
};

}  // namespace sim2d::nav2
