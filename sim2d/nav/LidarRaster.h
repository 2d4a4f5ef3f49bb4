#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/base/Types.h"

/// What the beams of a lidar meet first, shape by shape instead of ray by ray.
namespace sim2d {

using base::Vec2;

/// Beams from the origin, evenly counter-clockwise from +x. A shape covers an interval of them,
/// found by a pseudo-angle that grows with the angle; 1/distance to a straight edge is linear in a
/// beam's direction, so a beam costs two products and no division. Equal to casting each beam
/// alone. Thread: one at a time. Allocates when made and never again.
class LidarRaster {
 public:
  /// `perBeam` [rad] in [1e-4, 2 pi], the beams within one turn; `range` [m] > 0.
  LidarRaster(int beams, double perBeam, double range);

  void clear();  // nothing is met
  void block();  // the origin lies inside something: all beams meet it at once
  /// Seen from its right only: the solid lies to the left of a→b.
  void addEdge(const Vec2& a, const Vec2& b);
  void addCircle(const Vec2& centre, double radius);

  /// Beams of numbers in [first, end), counted on beyond the last one: number `beams` is 0 again.
  struct Beams {
    int first = 0, end = 0;
  };
  /// Those that meet the circle; all when the origin lies in it.
  Beams beamsOf(const Vec2& centre, double radius) const;
  /// Each of them meets something that is nearer than `distance` [m].
  bool areCovered(const Beams& beams, double distance) const;
  /// Of a circle within the larger one that the beams are of.
  void addCircle(const Vec2& centre, double radius, const Beams& beams);

  /// [m]; `range` where nothing is met within it.
  void writeDistances(std::vector<double>& distances) const;

 private:
  /// In the order of angles: [0, 4] for a whole turn from +x.
  static double pseudoAngle(const Vec2& direction);
  int firstFrom(double pseudo) const;
  Beams beamsBetween(const Vec2& first, const Vec2& last) const;
  void coverByEdge(int first, int end, const Vec2& slope);
  void coverByCircle(int first, int end, const Vec2& centre, double radius);
  void castBeam(int beam, const Vec2& a, const Vec2& b);
  Vec2 directionOfBeam(int beam) const;
  template <class Visit>
  void forRanges(const Beams& beams, Visit visit) const;

  int beams_;
  double range_;
  double perPseudo_;  // buckets per unit of pseudo-angle
  std::vector<double> cosines_, sines_, pseudos_;
  std::vector<int> start_;        // by bucket of pseudo-angle: first beam at or after its begin
  std::vector<double> nearness_;  // 1/distance [1/m], by beam
};

}  // namespace sim2d
