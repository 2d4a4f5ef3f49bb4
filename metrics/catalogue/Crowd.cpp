#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"
#include "metrics/catalogue/CrowdCells.h"

/// The people as a crowd, with or without a robot.
namespace metrics {

namespace {

constexpr char kNobody[] = "nobody in the record";
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kWalkingSpeed = 0.05;  // [m/s] slower has no direction

/// Samples at least crowd_interval apart: the crowd measures are costly and change slowly.
std::vector<std::size_t> looks(const Recording& recording, const MetricParameters& parameters) {
  std::vector<std::size_t> samples;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double since = samples.empty()
                             ? std::numeric_limits<double>::infinity()
                             : recording.samples[i].time - recording.samples[samples.back()].time;
    if (since >= parameters.crowdInterval - 1e-9) {
      samples.push_back(i);
    }
  }
  return samples;
}

using Measure = double (*)(const Sample&, const MetricParameters&);

/// Mean over the looks where the measure is defined.
MetricFunction meanOfLooks(Measure measure) {
  return [measure](const Recording& recording, const MetricParameters& parameters) {
    double sum = 0.0;
    double count = 0.0;
    for (const std::size_t i : looks(recording, parameters)) {
      const double value = measure(recording.samples[i], parameters);
      sum += std::isnan(value) ? 0.0 : value;
      count += std::isnan(value) ? 0.0 : 1.0;
    }
    return count > 0.0 ? numberValue(sum / count) : undefinedValue(kNobody);
  };
}

MetricFunction largestOfLooks(Measure measure) {
  return [measure](const Recording& recording, const MetricParameters& parameters) {
    double largest = kNaN;
    for (const std::size_t i : looks(recording, parameters)) {
      const double value = measure(recording.samples[i], parameters);
      largest = value <= largest || std::isnan(value) ? largest : value;
    }
    return std::isnan(largest) ? undefinedValue(kNobody) : numberValue(largest);
  };
}

std::vector<Vec2> positionsOf(const Sample& sample) {
  std::vector<Vec2> positions;
  for (const Person& person : sample.people) {
    positions.push_back(person.position);
  }
  return positions;
}

double meanOf(const std::vector<double>& values) {
  return values.empty() ? kNaN : sumOf(values) / static_cast<double>(values.size());
}

double classicDensity(const Sample& sample, const MetricParameters& parameters) {
  const double area = base::kPi * parameters.crowdRadius * parameters.crowdRadius;
  std::vector<double> densities;
  for (const std::vector<Vec2>& others : neighbours(positionsOf(sample), parameters.crowdRadius)) {
    densities.push_back((1.0 + static_cast<double>(others.size())) / area);
  }
  return meanOf(densities);
}

std::vector<double> voronoiDensities(const Sample& sample, const MetricParameters& parameters) {
  const std::vector<Vec2> positions = positionsOf(sample);
  const std::vector<std::vector<Vec2>> others = neighbours(positions, 2.0 * parameters.crowdRadius);
  std::vector<double> densities;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const double area = cellArea(positions[k], others[k], parameters.crowdRadius);
    densities.push_back(area > 0.0 ? 1.0 / area : 0.0);
  }
  return densities;
}

double voronoiDensity(const Sample& sample, const MetricParameters& parameters) {
  return meanOf(voronoiDensities(sample, parameters));
}

/// One point of the fundamental diagram: flow per metre of width.
double specificFlow(const Sample& sample, const MetricParameters& parameters) {
  const std::vector<double> densities = voronoiDensities(sample, parameters);
  std::vector<double> flows;
  for (std::size_t k = 0; k < densities.size(); ++k) {
    flows.push_back(densities[k] * sample.people[k].speed);
  }
  return meanOf(flows);
}

double polarisation(const Sample& sample, const MetricParameters& /*parameters*/) {
  Vec2 sum = Vec2::Zero();
  double count = 0.0;
  for (const Person& person : sample.people) {
    if (person.speed > kWalkingSpeed) {
      sum += person.velocity / person.speed;
      count += 1.0;
    }
  }
  return count > 0.0 ? lengthOf(sum) / count : kNaN;
}

/// Axis along which most walk, whichever way.
Vec2 mainAxis(const Sample& sample) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Person& person : sample.people) {
    xx += person.velocity.x() * person.velocity.x();
    xy += person.velocity.x() * person.velocity.y();
    yy += person.velocity.y() * person.velocity.y();
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  return {std::cos(angle), std::sin(angle)};
}

struct Walker {
  double place = 0.0;  // across the main axis
  bool forward = true;
};

/// Who walks, sorted across the main axis.
std::vector<Walker> walkersOf(const Sample& sample) {
  const Vec2 axis = mainAxis(sample);
  std::vector<Walker> walkers;
  for (const Person& person : sample.people) {
    if (person.speed > kWalkingSpeed) {
      walkers.push_back({base::cross(axis, person.position), axis.dot(person.velocity) > 0.0});
    }
  }
  std::sort(walkers.begin(), walkers.end(),
            [](const Walker& a, const Walker& b) { return a.place < b.place; });
  return walkers;
}

double laneOrder(const Sample& sample, const MetricParameters& parameters) {
  const std::vector<Walker> walkers = walkersOf(sample);
  std::vector<double> forward(walkers.size() + 1, 0.0);  // how many up to here
  for (std::size_t k = 0; k < walkers.size(); ++k) {
    forward[k + 1] = forward[k] + (walkers[k].forward ? 1.0 : 0.0);
  }
  double sum = 0.0;
  std::size_t low = 0;
  std::size_t high = 0;
  for (const Walker& walker : walkers) {
    while (walkers[low].place < walker.place - parameters.laneWidth) {
      ++low;
    }
    while (high < walkers.size() && walkers[high].place <= walker.place + parameters.laneWidth) {
      ++high;
    }
    const double all = static_cast<double>(high - low);
    const double difference = 2.0 * (forward[high] - forward[low]) - all;
    sum += difference * difference / (all * all);
  }
  return walkers.empty() ? kNaN : sum / static_cast<double>(walkers.size());
}

/// The way from a to b meets the line between the two ends.
bool crosses(const Vec2& a, const Vec2& b, const Vec2& from, const Vec2& to) {
  const Vec2 line = to - from;
  const double before = base::cross(line, a - from);
  const double after = base::cross(line, b - from);
  if ((before > 0.0) == (after > 0.0)) {
    return false;
  }
  const Vec2 point = a + before / (before - after) * (b - a);
  const double place = line.dot(point - from);
  return place >= 0.0 && place <= line.squaredNorm();
}

MetricValue lineCrossings(const Recording& recording, const MetricParameters& parameters) {
  const Vec2 from(parameters.flowLineX1, parameters.flowLineY1);
  const Vec2 to(parameters.flowLineX2, parameters.flowLineY2);
  if (from == to) {
    return undefinedValue("no line is set (flow_line_x1 ...)");
  }
  double count = 0.0;
  for (std::size_t i = 1; i < recording.size(); ++i) {
    const Sample& before = recording.samples[i - 1];
    for (const Person& person : recording.samples[i].people) {
      const Person* const then = findPerson(before, person.id);
      count += then != nullptr && crosses(then->position, person.position, from, to) ? 1.0 : 0.0;
    }
  }
  return countValue(count);
}

MetricValue lineFlow(const Recording& recording, const MetricParameters& parameters) {
  const MetricValue crossings = lineCrossings(recording, parameters);
  if (!crossings.value || !(recording.duration() > 0.0)) {
    return crossings.value ? undefinedValue("the record has no duration") : crossings;
  }
  const double width = lengthOf(Vec2(parameters.flowLineX2 - parameters.flowLineX1,
                                     parameters.flowLineY2 - parameters.flowLineY1));
  return numberValue(*crossings.value / recording.duration() / width);
}

struct Entry {
  const char *key, *name, *unit;
  const char *formula, *source, *range;
};

void addEntry(MetricRegistry& to, const Entry& entry, MetricFunction compute,
              Kind kind = Kind::Number) {
  to.add({entry.key, entry.name, entry.unit, Category::Social, Better::Neutral, Needs{false, true},
          entry.formula, entry.source, entry.range, kind, 0, ""},
         std::move(compute));
}

}  // namespace

void addCrowd(MetricRegistry& to) {
  addEntry(to,
           {"crowd_density", "Density around people", "1/m²",
            "mean over looks (crowd_interval apart) and people of the number within crowd_radius, "
            "themselves included, / (pi crowd_radius^2)",
            "Steffen and Seyfried 2010", "[0, inf)"},
           meanOfLooks(classicDensity));
  addEntry(to,
           {"crowd_voronoi_density", "Voronoi density", "1/m²",
            "mean over looks and people of 1/area of their cell, cut at crowd_radius",
            "Steffen and Seyfried 2010", "[0, inf)"},
           meanOfLooks(voronoiDensity));
  addEntry(to,
           {"crowd_voronoi_density_max", "Voronoi density, largest look", "1/m²",
            "max over looks of the mean over people of the same", "Steffen and Seyfried 2010",
            "[0, inf)"},
           largestOfLooks(voronoiDensity));
  addEntry(to,
           {"crowd_specific_flow", "Flow per metre of width", "1/(m s)",
            "mean over looks and people of Voronoi density * |u_a| (fundamental diagram)",
            "Seyfried et al. 2005", "[0, inf)"},
           meanOfLooks(specificFlow));
  addEntry(to,
           {"crowd_polarisation", "Common direction of the crowd", "",
            "mean over looks of |mean of u_a/|u_a|| of who walks", "Vicsek et al. 1995", "[0, 1]"},
           meanOfLooks(polarisation));
  addEntry(to,
           {"crowd_lane_order", "Lanes of the crowd", "",
            "mean over looks and walking people of ((same - opposite)/(same + opposite))^2 within "
            "lane_width to each side of the main axis of walking",
            "Rex and Loewen 2007", "[0, 1]"},
           meanOfLooks(laneOrder));
  addEntry(to,
           {"line_crossings", "People through the line", "",
            "number of steps of people that cross the line (flow_line_x1 ...), both ways",
            "Seyfried et al. 2005", "0, 1, ..."},
           lineCrossings, Kind::Count);
  addEntry(to,
           {"line_flow", "Flow through the line", "1/(m s)",
            "line_crossings / T / length of the line", "Seyfried et al. 2005", "[0, inf)"},
           lineFlow);
}

}  // namespace metrics
