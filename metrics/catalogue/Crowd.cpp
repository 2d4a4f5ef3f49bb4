#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "metrics/TermStatistics.h"
#include "metrics/VoronoiCells.h"

/// Crowd measures, with or without a robot.
namespace metrics {

namespace {

constexpr double kWalkingSpeed = 0.05;  // [m/s] slower people have no direction

// Indices of the measures.
constexpr std::size_t kDensity = 0;
constexpr std::size_t kVoronoiDensity = 1;
constexpr std::size_t kSpecificFlow = 2;
constexpr std::size_t kPolarisation = 3;
constexpr std::size_t kLaneOrder = 4;
constexpr std::size_t kMeasures = 5;
using Measures = std::array<double, kMeasures>;  // of one sample; NaN: undefined

/// Positions of all people, followed by the images of those near the seam.
std::vector<Vec2> withPeriodicImages(const Sample& sample, const Seam& seam, double reach) {
  std::vector<Vec2> places;
  for (const Pedestrian& person : sample.people) {
    places.push_back(person.position);
  }
  const std::size_t count = seam.isThere() ? places.size() : 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double from = places[k].x() - seam.low;
    if (from < reach) {
      places.emplace_back(places[k].x() + seam.length, places[k].y());
    }
    if (from > seam.length - reach) {
      places.emplace_back(places[k].x() - seam.length, places[k].y());
    }
  }
  return places;
}

std::vector<std::vector<Vec2>> othersOf(const std::vector<Vec2>& places, double reach) {
  std::vector<std::vector<Vec2>> others;
  for (const std::vector<std::size_t>& numbers : neighboursWithin(places, reach)) {
    std::vector<Vec2>& near = others.emplace_back();
    for (const std::size_t number : numbers) {
      near.push_back(places[number]);
    }
  }
  return others;
}

double classicDensity(const std::vector<std::vector<Vec2>>& others,
                      const std::vector<Vec2>& positions, std::size_t count, double radius) {
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    sum += 1.0;
    for (const Vec2& other : others[k]) {
      sum += (other - positions[k]).squaredNorm() <= radius * radius ? 1.0 : 0.0;
    }
  }
  return sum / static_cast<double>(count) / (base::kPi * radius * radius);
}

/// Densities and the flow per metre of width: one point of the fundamental diagram.
void addDensities(const Sample& sample, const RunContext& context, double radius,
                  VoronoiCellAreas& areas, Measures& to) {
  const std::vector<Vec2> positions = withPeriodicImages(sample, context.seam, 2.0 * radius);
  const std::vector<std::vector<Vec2>> others = othersOf(positions, 2.0 * radius);
  to[kDensity] = classicDensity(others, positions, sample.people.size(), radius);
  double density = 0.0;
  double flow = 0.0;
  for (std::size_t k = 0; k < sample.people.size(); ++k) {
    const double area = areas.areaOf(positions[k], others[k], context);
    const double own = area > 0.0 ? 1.0 / area : 0.0;
    density += own;
    flow += own * sample.people[k].speed;
  }
  const double count = static_cast<double>(sample.people.size());
  to[kVoronoiDensity] = density / count;
  to[kSpecificFlow] = flow / count;
}

double polarisation(const Sample& sample) {
  Vec2 sum = Vec2::Zero();
  double count = 0.0;
  for (const Pedestrian& person : sample.people) {
    if (person.speed > kWalkingSpeed) {
      sum += person.velocity / person.speed;
      count += 1.0;
    }
  }
  return count > 0.0 ? lengthOf(sum) / count : kNaN;
}

/// The axis along which most people walk, in either direction. None: no direction stands out, apart
/// from rounding.
std::optional<Vec2> mainAxis(const Sample& sample) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Pedestrian& person : sample.people) {
    xx += person.velocity.x() * person.velocity.x();
    xy += person.velocity.x() * person.velocity.y();
    yy += person.velocity.y() * person.velocity.y();
  }
  constexpr double kRounding = 1e-9;
  if (std::max(std::fabs(2.0 * xy), std::fabs(xx - yy)) <= kRounding * (xx + yy)) {
    return std::nullopt;
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  return Vec2(std::cos(angle), std::sin(angle));
}

struct Walker {
  double place = 0.0;  // coordinate across the main axis
  bool forward = true;
};

/// Walking people, sorted across the main axis; none without such an axis.
std::vector<Walker> walkersOf(const Sample& sample) {
  const std::optional<Vec2> axis = mainAxis(sample);
  std::vector<Walker> walkers;
  if (!axis) {
    return walkers;
  }
  for (const Pedestrian& person : sample.people) {
    if (person.speed > kWalkingSpeed) {
      walkers.push_back({base::cross(*axis, person.position), axis->dot(person.velocity) > 0.0});
    }
  }
  std::sort(walkers.begin(), walkers.end(),
            [](const Walker& a, const Walker& b) { return a.place < b.place; });
  return walkers;
}

double laneOrder(const Sample& sample, double laneWidth) {
  const std::vector<Walker> walkers = walkersOf(sample);
  std::vector<double> forward(walkers.size() + 1, 0.0);  // prefix counts
  for (std::size_t k = 0; k < walkers.size(); ++k) {
    forward[k + 1] = forward[k] + (walkers[k].forward ? 1.0 : 0.0);
  }
  double sum = 0.0;
  std::size_t low = 0;
  std::size_t high = 0;
  for (const Walker& walker : walkers) {
    while (walkers[low].place < walker.place - laneWidth) {
      ++low;
    }
    while (high < walkers.size() && walkers[high].place <= walker.place + laneWidth) {
      ++high;
    }
    const double all = static_cast<double>(high - low);
    const double difference = 2.0 * (forward[high] - forward[low]) - all;
    sum += difference * difference / (all * all);
  }
  return walkers.empty() ? kNaN : sum / static_cast<double>(walkers.size());
}

/// Measures the crowd at intervals of at least crowd_interval, since the measures are costly and
/// change slowly.
class CrowdMeasurements : public Accumulator {
 public:
  explicit CrowdMeasurements(const MetricParameters& parameters) : areas_(parameters.crowdRadius) {}

  void add(const Instant& at) override {
    if (at.now.time - last_ >= at.parameters.crowdInterval - kTimeSlack) {
      last_ = at.now.time;
      look(at);
    }
    for (std::size_t k = 0; k < kMeasures; ++k) {
      series_[k].add(at, measures_[k]);
    }
  }

  /// Mean over the measurements where the measure is defined. Its series is constant in between.
  MetricValue mean(std::size_t measure) const {
    return withSeries(counts_[measure] > 0.0 ? sums_[measure] / counts_[measure] : kNaN,
                      series_[measure].values());
  }
  double largestVoronoiDensity() const { return largest_; }

 private:
  void look(const Instant& at) {
    measures_.fill(kNaN);
    if (!at.now.people.empty()) {
      addDensities(at.now, at.context, at.parameters.crowdRadius, areas_, measures_);
      measures_[kPolarisation] = polarisation(at.now);
      measures_[kLaneOrder] = laneOrder(at.now, at.parameters.laneWidth);
    }
    largest_ = std::fmax(largest_, measures_[kVoronoiDensity]);
    for (std::size_t k = 0; k < kMeasures; ++k) {
      if (!std::isnan(measures_[k])) {
        sums_[k] += measures_[k];
        counts_[k] += 1.0;
      }
    }
  }

  VoronoiCellAreas areas_;
  double last_ = -std::numeric_limits<double>::infinity();  // [s]
  Measures measures_{}, sums_{}, counts_{};
  double largest_ = kNaN;  // Voronoi density [1/m^2]
  std::array<SeriesColumn, kMeasures> series_;
};

MetricComputation meanOf(std::size_t measure, const char* why = kNoPeople) {
  return metricOf<CrowdMeasurements>(
      [measure](const CrowdMeasurements& looks) { return looks.mean(measure); }, why);
}

constexpr char kCrowdMetrics[] = R"(
= Social Behavior|neutral|people|Steffen and Seyfried 2010
crowd_density|Density around people|1/m²|[0, inf)|mean over crowd samples (crowd_interval) with people of the mean over people of n/(pi crowd_radius^2), n =
  people within crowd_radius of q, themselves included
crowd_voronoi_density|Voronoi density|1/m²|[0, inf)|mean over crowd samples (crowd_interval) with people of the mean over people of 1/area of their cell (0 if
  that is 0): the points that are within crowd_radius of q, not behind a wall as seen from q (edges of all entries of obstacles but doors), and not nearer to
  another person within 2 crowd_radius of q (at another position) between whom and q there is no wall
crowd_voronoi_density_max|Voronoi density, largest sample|1/m²|[0, inf)|max over crowd samples of the mean over people of the same
= Social Behavior|neutral|people|Seyfried et al. 2005
crowd_specific_flow|Specific flow of the crowd|1/(m s)|[0, inf)|mean over crowd samples with people of the mean over people of 1/area of their cell * |u|
  (fundamental diagram)
= Social Behavior|neutral|people|Vicsek et al. 1995
crowd_polarisation|Crowd polarisation||[0, 1]|mean over crowd samples at which people walk (|u| > 0.05 m/s) of |mean of u/|u|| of those who walk
= Social Behavior|neutral|people|Rex and Loewen 2007
crowd_lane_order|Crowd lane order||[0, 1]|mean over crowd samples at which people walk and that have a main axis of the mean over those who walk, a,
  of ((same - opposite)/(same + opposite))^2: of the people b who walk with |n q_b - n q_a| <= lane_width, a included, "same" have m u_b > 0 if and
  only if m u_a > 0, the others are "opposite"; main axis m = (cos z, sin z), z = atan2(2 sum u_x u_y, sum (u_x^2 - u_y^2))/2 over all people at that
  crowd sample, none if both sums are at most 1e-9 sum |u|^2 in magnitude, n = m turned left
)";

}  // namespace

void addCrowd(MetricRegistry& to) {
  to.add(kCrowdMetrics,
         {{"crowd_density", meanOf(kDensity)},
          {"crowd_voronoi_density", meanOf(kVoronoiDensity)},
          {"crowd_voronoi_density_max",
           metricOf<CrowdMeasurements>(&CrowdMeasurements::largestVoronoiDensity, kNoPeople)},
          {"crowd_specific_flow", meanOf(kSpecificFlow)},
          {"crowd_polarisation", meanOf(kPolarisation, "no person walks at a crowd sample")},
          {"crowd_lane_order", meanOf(kLaneOrder, "no person walks along a main axis")}});
}

}  // namespace metrics
