#pragma once

#include "sim2d/world/crowd/CrowdKernel.h"
#include "sim2d/world/crowd/CrowdLanes.h"

/// The social force on one person, over all candidates: first those are picked whose force can be
/// above the cut-off, then their forces are computed. To be included once in the file of each
/// instruction set.
namespace sim2d {
namespace {

/// The bound of SocialForce.h, multiplied out so that no division is left; for pairs that the
/// interaction vector points away from the angle is at least a quarter turn.
struct Bound {
  explicit Bound(const CrowdReceiver& receiver) {
    const float least = receiver.n < receiver.nPrime ? receiver.n : receiver.nPrime;
    const float side = least * receiver.gamma * receiver.lambda;
    const float quarter = least * receiver.gamma * 1.5707F;
    lambda = fill(receiver.lambda);
    twiceLambda = fill(2.0F * receiver.lambda);
    squaredLambda = fill(receiver.lambda * receiver.lambda);
    squaredGamma = fill(receiver.gamma * receiver.gamma);
    sideways = fill(side * side);
    behind = fill(quarter * quarter);
    cutOff = fill(receiver.cutOff);
  }

  /// All squared and times powers of the distance, see the names.
  Mask isAbove(Lanes dx, Lanes dy, Lanes dvx, Lanes dvy) const {
    const Lanes d2 = dx * dx + dy * dy;
    const Lanes d = squareRoot(d2);
    const Lanes speed2 = dvx * dvx + dvy * dvy;
    const Lanes dot = dvx * dx + dvy * dy;
    const Lanes cross = dvx * dy - dvy * dx;
    const Lanes length2TimesD2 = (squaredLambda * speed2) * d2 + (twiceLambda * dot) * d + d2;
    const Lanes turned =
        choose(lambda * dot + d < fill(0.0F), behind * length2TimesD2, sideways * (cross * cross));
    const Lanes restTimesD2 = cutOff * d2 - turned;
    const Lanes bound = (squaredGamma * length2TimesD2) * (restTimesD2 * restTimesD2);
    const Lanes d4 = d2 * d2;
    return (d4 * d4 <= bound) & (fill(0.0F) < restTimesD2);
  }

  Lanes lambda, twiceLambda, squaredLambda, squaredGamma, sideways, behind, cutOff;
};

/// The receiver in every lane.
struct Place {
  explicit Place(const CrowdReceiver& receiver)
      : x(fill(receiver.x)), y(fill(receiver.y)), vx(fill(receiver.vx)), vy(fill(receiver.vy)) {}
  Lanes x, y, vx, vy;
};

/// Marks in `chosen`, a word per register, the candidates whose force may be above the cut-off.
/// Apart from the packing, so that no jump has to wait for a root. Returns how many are in the
/// receiver's place.
inline int markStrong(const CrowdColumns& candidates, const CrowdReceiver& receiver, int* chosen) {
  const Bound bound(receiver);
  const Place self(receiver);
  const Lanes nearest2 = fill(kCrowdTouching * kCrowdTouching);
  int touching = 0;
  int word = 0;
  for (int i = 0; i < receiver.candidates; i += kWidth) {
    const Lanes dx = load(candidates.x + i) - self.x;
    const Lanes dy = load(candidates.y + i) - self.y;
    const Lanes dvx = self.vx - load(candidates.vx + i);
    const Lanes dvy = self.vy - load(candidates.vy + i);
    const Bits isTouching = bitsOf(dx * dx + dy * dy <= nearest2);
    chosen[word] = static_cast<int>(bitsOf(bound.isAbove(dx, dy, dvx, dvy)) & ~isTouching);
    ++word;
    if (isTouching != 0) {
      touching += countOf(isTouching);
    }
  }
  return touching;
}

/// Packs the chosen candidates one after the other; returns how many, fills up the last register
/// with pairs too far apart to feel anything.
inline int pack(const CrowdColumns& candidates, const CrowdReceiver& receiver, const int* chosen,
                const CrowdPairs& pairs) {
  const Place self(receiver);
  int count = 0;
  for (int i = 0, word = 0; i < receiver.candidates; i += kWidth, ++word) {
    const auto bits = static_cast<Bits>(chosen[word]);
    if (bits != 0) {
      const Packing packing(bits);
      packing.put(pairs.dx + count, load(candidates.x + i) - self.x);
      packing.put(pairs.dy + count, load(candidates.y + i) - self.y);
      packing.put(pairs.dvx + count, self.vx - load(candidates.vx + i));
      packing.put(pairs.dvy + count, self.vy - load(candidates.vy + i));
      packing.putIndices(pairs.index + count, i);
      count += countOf(bits);
    }
  }
  for (int i = count; i < count + kCrowdLanes; i += kWidth) {
    store(pairs.dx + i, fill(1e6F));
    store(pairs.dy + i, fill(0.0F));
    store(pairs.dvx + i, fill(0.0F));
    store(pairs.dvy + i, fill(0.0F));
  }
  return count;
}

/// socialForce() in units of k_s.
struct Law {
  explicit Law(const CrowdReceiver& receiver)
      : lambda(fill(receiver.lambda)),
        gamma(fill(receiver.gamma)),
        inverseGamma(fill(1.0F / receiver.gamma)),
        n(fill(receiver.n)),
        nPrime(fill(receiver.nPrime)),
        epsilon(fill(receiver.epsilon)) {}

  struct Force {
    Lanes x, y;
  };
  Force of(Lanes dx, Lanes dy, Lanes dvx, Lanes dvy) const {
    const Lanes d = squareRoot(dx * dx + dy * dy);
    const Lanes inverse = fill(1.0F) / d;
    const Lanes ex = dx * inverse;
    const Lanes ey = dy * inverse;
    const Lanes ix = lambda * dvx + ex;
    const Lanes iy = lambda * dvy + ey;
    const Lanes length2 = ix * ix + iy * iy;
    const Mask vanishes = length2 < fill(1e-12F);
    const Lanes length = squareRoot(choose(vanishes, fill(1.0F), length2));
    const Lanes inverseLength = fill(1.0F) / length;
    const Lanes reach = gamma * length;
    const Lanes angle = angleOf(ix * ey - iy * ex, ix * ex + iy * ey);
    const Lanes shifted = angle + epsilon * reach;
    const Lanes wrapped =
        choose(fill(3.14159265F) < shifted, shifted - fill(6.28318531F),
               choose(shifted < fill(-3.14159265F), shifted + fill(6.28318531F), shifted));
    const Lanes turn = reach * wrapped;
    const Lanes forSpeed = nPrime * turn;
    const Lanes forTurn = n * turn;
    const Lanes fade = fill(0.0F) - (d * inverseLength) * inverseGamma;
    const Lanes slowing = exponential(fade - forSpeed * forSpeed);
    const Lanes amount = exponential(fade - forTurn * forTurn);
    const Lanes turning =
        choose(magnitude(wrapped) <= fill(0.0F), fill(0.0F), withSign(amount, wrapped));
    const Lanes tx = ix * inverseLength;
    const Lanes ty = iy * inverseLength;
    const Lanes none = fill(0.0F);
    return {choose(vanishes, none, turning * ty - slowing * tx),
            choose(vanishes, none, none - (slowing * ty + turning * tx))};
  }

  Lanes lambda, gamma, inverseGamma, n, nPrime, epsilon;
};

/// The columns to one number, always in the same order.
inline float sumOf(const float* columns) {
  float part[kCrowdLanes / 2];
  for (int i = 0; i < 8; ++i) {
    part[i] = columns[i] + columns[i + 8];
  }
  for (int half = 4; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) {
      part[i] = part[i] + part[i + half];
    }
  }
  return part[0];
}

inline void sumPairs(const CrowdPairs& pairs, CrowdResult& result) {
  constexpr int kParts = kCrowdLanes / kWidth;
  Lanes x[kParts];
  Lanes y[kParts];
  for (int part = 0; part < kParts; ++part) {
    x[part] = y[part] = fill(0.0F);
  }
  for (int i = 0; i < result.pairs;) {
    for (int part = 0; part < kParts; ++part, i += kWidth) {
      x[part] = x[part] + load(pairs.fx + i);
      y[part] = y[part] + load(pairs.fy + i);
    }
  }
  float columns[2][kCrowdLanes];
  for (int part = 0, lane = 0; part < kParts; ++part, lane += kWidth) {
    store(columns[0] + lane, x[part]);
    store(columns[1] + lane, y[part]);
  }
  result.x = sumOf(columns[0]);
  result.y = sumOf(columns[1]);
}

/// Pairs farther apart than the free discs round both reach. Forces below the cut-off are dropped
/// instead of being looked at.
inline int findDoubtful(const CrowdColumns& candidates, const CrowdReceiver& receiver,
                        const CrowdPairs& pairs, int count) {
  const Lanes free2 = fill(receiver.room * receiver.room);
  const float least2 = receiver.leastLooked * receiver.leastLooked;
  int doubtful = 0;
  for (int first = 0; first < count; first += kWidth) {
    const Lanes dx = load(pairs.dx + first);
    const Lanes dy = load(pairs.dy + first);
    Bits beyond = bitsOf(free2 <= dx * dx + dy * dy);
    for (int i = first; i < count && beyond != 0; ++i, beyond >>= 1U) {
      if ((beyond & 1U) == 0) {
        continue;
      }
      const float reach = receiver.room + candidates.room[pairs.index[i]];
      if (pairs.dx[i] * pairs.dx[i] + pairs.dy[i] * pairs.dy[i] < reach * reach) {
        continue;
      }
      if (pairs.fx[i] * pairs.fx[i] + pairs.fy[i] * pairs.fy[i] < least2) {
        pairs.fx[i] = pairs.fy[i] = 0.0F;
      } else {
        pairs.doubtful[doubtful] = i;
        ++doubtful;
      }
    }
  }
  return doubtful;
}

/// Appends `count` floats to each column of `into`, which holds `at` of them; reads and writes up
/// to a register more.
inline void appendColumns(const CrowdColumns& from, int begin, int count, const CrowdColumns& into,
                          int at) {
  for (int i = 0; i < count; i += kWidth) {
    store(into.x + at + i, load(from.x + begin + i));
    store(into.y + at + i, load(from.y + begin + i));
    store(into.vx + at + i, load(from.vx + begin + i));
    store(into.vy + at + i, load(from.vy + begin + i));
    store(into.room + at + i, load(from.room + begin + i));
  }
}

inline CrowdResult forceOn(const CrowdColumns& candidates, const CrowdReceiver& receiver,
                           const CrowdPairs& pairs) {
  CrowdResult result;
  result.touching = markStrong(candidates, receiver, pairs.doubtful);
  result.pairs = pack(candidates, receiver, pairs.doubtful, pairs);
  const Law law(receiver);
  for (int i = 0; i < result.pairs; i += kCrowdLanes) {
    for (int k = i; k < i + kCrowdLanes; k += kWidth) {
      const Law::Force force =
          law.of(load(pairs.dx + k), load(pairs.dy + k), load(pairs.dvx + k), load(pairs.dvy + k));
      store(pairs.fx + k, force.x);
      store(pairs.fy + k, force.y);
    }
  }
  if (receiver.seesWalls) {
    result.doubtful = findDoubtful(candidates, receiver, pairs, result.pairs);
  }
  sumPairs(pairs, result);
  return result;
}

}  // namespace
}  // namespace sim2d
