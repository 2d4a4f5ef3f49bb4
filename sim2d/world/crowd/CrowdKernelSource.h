#pragma once

#include "sim2d/world/crowd/CrowdKernel.h"
#include "sim2d/world/crowd/CrowdMath.h"

/// Social forces on a batch of people: first the candidates with a force above the cut-off are
/// selected for each person, then the forces of all are computed. Include exactly once per
/// instruction-set file.
namespace sim2d {
namespace {

/// The bound of SocialForce.h in the frame of the line between two people, in which the interaction
/// vector is (along, across). If it points away from the other, the angle is at least a quarter
/// turn. The relative error of the root, 0.2 %, is also that of the bound.
struct Bound {
  explicit Bound(const CrowdForceParameters& law) {
    const float least = law.n < law.nPrime ? law.n : law.nPrime;
    const float side = least * law.gamma;
    const float quarter = side * 1.5707F;
    halfLambda = fill(0.5F * law.lambda);
    moreLambda = fill(1.5F * law.lambda);
    sideways = fill(side * side * law.gamma);
    behind = fill(quarter * quarter * law.gamma);
    reach = fill(law.cutOff * law.gamma);
  }

  /// Selects all touching pairs, those above the bound, and a few more.
  Mask isAbove(Lanes dx, Lanes dy, Lanes dvx, Lanes dvy) const {
    const Lanes none = fill(0.0F);
    const Lanes apart2 = dx * dx + dy * dy;
    const Lanes d2 = max(fill(kCoincidentDistance * kCoincidentDistance), apart2);
    const Lanes guess = approximateInverseRoot(d2);
    const Lanes scale = guess * (moreLambda - halfLambda * d2 * guess * guess);  // lambda / d
    const Lanes along = (dvx * dx + dvy * dy) * scale + fill(1.0F);
    const Lanes across = (dvx * dy - dvy * dx) * scale;
    const Lanes across2 = across * across;
    const Lanes length2 = along * along + across2;
    const Lanes turned = select(along < none, behind * length2, sideways * across2);
    const Lanes rest = reach - turned;
    return (d2 <= length2 * (rest * rest)) & (none < rest);
  }

  Lanes halfLambda, moreLambda, sideways, behind, reach;
};

/// The receiver, broadcast to all lanes.
struct Place {
  explicit Place(const CrowdReceiver& receiver)
      : x(fill(receiver.x)), y(fill(receiver.y)), vx(fill(receiver.vx)), vy(fill(receiver.vy)) {}
  Lanes x, y, vx, vy;
};

/// Lists the candidates whose force may be above the cut-off, one mask per register. Separate from
/// packing to avoid dependent branches. Returns the number of masks.
inline int selectCandidates(const CrowdColumns& crowd, const Bound& bound, const Place& self,
                            const CrowdSpan* span, const CrowdSpan* last, const CrowdPairs& pairs) {
  int words = 0;
  for (; span != last; ++span) {
    for (int i = span->first; i < span->last; i += kWidth) {
      const int left = span->last - i;
      const Bits inSpan = left < kWidth ? (1U << static_cast<unsigned>(left)) - 1U : kAllLanes;
      const Bits strong =
          bitsOf(bound.isAbove(load(crowd.x + i) - self.x, load(crowd.y + i) - self.y,
                               self.vx - load(crowd.vx + i), self.vy - load(crowd.vy + i))) &
          inSpan;
      pairs.word[words] = static_cast<int>(strong);
      pairs.wordAt[words] = i;
      words += strong != 0 ? 1 : 0;
    }
  }
  return words;
}

/// Pads with pairs that are too far apart to interact.
inline void padPairs(const CrowdPairs& pairs, int first) {
  for (int i = first; i < first + kCrowdLanes; i += kWidth) {
    store(pairs.x + i, fill(1e6F));
    store(pairs.y + i, fill(0.0F));
    store(pairs.vx + i, fill(0.0F));
    store(pairs.vy + i, fill(0.0F));
  }
}

/// Packs the selected candidates, relative to the receiver, contiguously from `first` on, and pads
/// the last register. Returns the end of the selection.
template <bool kWithSlots>
inline int pack(const CrowdColumns& crowd, const Place& self, int words, int first,
                const CrowdPairs& pairs) {
  int end = first;
  for (int k = 0; k < words; ++k) {
    const auto bits = static_cast<Bits>(pairs.word[k]);
    const int i = pairs.wordAt[k];
    const Packing packing(bits);
    packing.put(pairs.x + end, load(crowd.x + i) - self.x);
    packing.put(pairs.y + end, load(crowd.y + i) - self.y);
    packing.put(pairs.vx + end, self.vx - load(crowd.vx + i));
    packing.put(pairs.vy + end, self.vy - load(crowd.vy + i));
    if constexpr (kWithSlots) {
      packing.putIndices(pairs.slot + end, i);
    }
    end += countOf(bits);
  }
  padPairs(pairs, end);
  return end;
}

/// socialForce() in units of k_s.
struct Law {
  explicit Law(const CrowdForceParameters& law)
      : lambda(fill(law.lambda)),
        gamma(fill(law.gamma)),
        fading(fill(-kPerLn / law.gamma)),
        forTurn(fill(-kPerLn * law.n * law.n)),
        forSpeed(fill(-kPerLn * law.nPrime * law.nPrime)),
        epsilon(fill(law.epsilon)) {}

  struct Force {
    Group x, y;
    GroupMask touching;
  };
  /// Roots and the single division are the slowest operations, so lengths stay unscaled as long as
  /// possible.
  Force of(Group dx, Group dy, Group dvx, Group dvy) const {
    const Group d2 = dx * dx + dy * dy;
    const Group d = sqrt(d2);
    const Group along = lambda * (dvx * dx + dvy * dy) + d;
    const Group across = lambda * (dvx * dy - dvy * dx);
    const Group length2 = along * along + across * across;  // of the interaction vector, times d2
    const Group length = sqrt(length2);
    const Group inverse = fill(1.0F) / (d * length);
    const Group perDistance = length * inverse;
    const Group perLength = d * inverse;
    const Group cosine =
        along * perLength;  // of the angle from the interaction vector to the other
    const Group sine = across * perLength;
    const Group reach = gamma * (length * perDistance);
    const Group turn = reach * wrapped(angleOf(sine, cosine) + epsilon * reach);
    const Group turn2 = turn * turn;
    const Group fade = fading * (d2 * perLength);
    const Group slowing = powerOfTwo(fade + forSpeed * turn2);
    const Group turning = withSignOf(powerOfTwo(fade + forTurn * turn2), turn);
    const Group away = slowing * cosine + turning * sine;  // away from the other, and to its left
    const Group left = slowing * sine - turning * cosine;
    const GroupMask isTouching = d2 <= fill(kCoincidentDistance * kCoincidentDistance);
    const GroupMask acts =
        (fill(kCoincidentDistance * kCoincidentDistance) < d2) & (d2 * fill(1e-12F) <= length2);
    const Group none = fill(0.0F);
    return {select(acts, none - (away * dx + left * dy) * perDistance, none),
            select(acts, (left * dx - away * dy) * perDistance, none), isTouching};
  }

  static Group wrapped(Group angle) {
    const Group turn = fill(6.28318531F);
    const Group pi = fill(3.14159265F);
    const Group lower = select(pi < angle, angle - turn, angle);
    return select(lower < fill(-3.14159265F), lower + turn, lower);
  }
  /// `amount` with the sign of `side`; zero if `side` is zero.
  static Group withSignOf(Group amount, Group side) {
    return select(abs(side) <= fill(0.0F), fill(0.0F), withSign(amount, side));
  }

  static constexpr float kPerLn = 1.44269504F;  // converts to powers of two
  Lanes lambda, gamma, fading, forTurn, forSpeed, epsilon;
};

/// Sums the columns in a fixed order.
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

/// Accumulates the columns in as many registers as they need.
inline void sumPairs(const CrowdPairs& pairs, CrowdResult& result) {
  constexpr int kParts = kCrowdLanes / kWidth;
  Lanes x[kParts];
  Lanes y[kParts];
  for (int part = 0; part < kParts; ++part) {
    x[part] = y[part] = fill(0.0F);
  }
  for (int i = result.first; i < result.last;) {
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

/// True if a wall may stand between two people: their free discs do not overlap.
inline bool needsWallTest(const CrowdColumns& crowd, const CrowdReceiver& receiver,
                          const CrowdPairs& pairs, int pair) {
  const float dx = pairs.x[pair];
  const float dy = pairs.y[pair];
  const float reach = receiver.room + crowd.room[pairs.slot[pair]];
  return reach * reach <= dx * dx + dy * dy;
}

/// Appends the pairs of one receiver that need a wall test; returns their end. Forces below the
/// cut-off are set to zero instead.
inline int findWallTests(const CrowdColumns& crowd, const CrowdReceiver& receiver,
                         const CrowdResult& result, float minTestedForce, const CrowdPairs& pairs) {
  const Lanes free2 = fill(receiver.room * receiver.room);
  int end = result.firstDoubtful;
  for (int first = result.first; first < result.last; first += kWidth) {
    const Lanes dx = load(pairs.x + first);
    const Lanes dy = load(pairs.y + first);
    Bits beyond = bitsOf(free2 <= dx * dx + dy * dy);
    for (int i = first; i < result.last && beyond != 0; ++i, beyond >>= 1U) {
      if ((beyond & 1U) == 0 || !needsWallTest(crowd, receiver, pairs, i)) {
        continue;
      }
      const float size2 = pairs.fx[i] * pairs.fx[i] + pairs.fy[i] * pairs.fy[i];
      if (size2 < minTestedForce * minTestedForce) {
        pairs.fx[i] = pairs.fy[i] = 0.0F;
      } else {
        pairs.doubtful[end] = i;
        ++end;
      }
    }
  }
  return end;
}

/// Returns the end of all pairs.
template <bool kWithSlots>
inline int pickPairs(const CrowdColumns& crowd, const CrowdBatch& batch, const CrowdPairs& pairs) {
  const Bound bound(batch.law);
  int next = 0;
  for (int k = 0; k < batch.count; ++k) {
    const CrowdReceiver& receiver = batch.receivers[k];
    const Place self(receiver);
    const int words = selectCandidates(crowd, bound, self, batch.spans + receiver.firstSpan,
                                       batch.spans + receiver.lastSpan, pairs);
    CrowdResult& result = batch.results[k];
    result.first = next;
    result.last = pack<kWithSlots>(crowd, self, words, next, pairs);
    next = (result.last + kCrowdLanes - 1) / kCrowdLanes * kCrowdLanes;
  }
  for (int i = next; i < next + kGroupWidth; i += kCrowdLanes) {
    padPairs(pairs, i);
  }
  return next;
}

inline void computePairs(const CrowdForceParameters& parameters, int count,
                         const CrowdPairs& pairs) {
  const Law law(parameters);
  for (int i = 0; i < count; i += kGroupWidth) {
    const Law::Force force = law.of(loadGroup(pairs.x + i), loadGroup(pairs.y + i),
                                    loadGroup(pairs.vx + i), loadGroup(pairs.vy + i));
    storeGroup(pairs.fx + i, force.x);
    storeGroup(pairs.fy + i, force.y);
    storeCounts(pairs.touching + i / kWidth, force.touching);
  }
}

inline void forcesOf(const CrowdColumns& crowd, const CrowdBatch& batch, const CrowdPairs& pairs) {
  const int count = batch.law.testsWalls ? pickPairs<true>(crowd, batch, pairs)
                                         : pickPairs<false>(crowd, batch, pairs);
  computePairs(batch.law, count, pairs);
  int doubtful = 0;
  for (int k = 0; k < batch.count; ++k) {
    CrowdResult& result = batch.results[k];
    result.firstDoubtful = doubtful;
    if (batch.law.testsWalls) {
      doubtful = findWallTests(crowd, batch.receivers[k], result, batch.law.minTestedForce, pairs);
    }
    result.lastDoubtful = doubtful;
    result.touching = 0;
    for (int i = result.first; i < result.last; i += kWidth) {
      result.touching += pairs.touching[i / kWidth];
    }
    sumPairs(pairs, result);
  }
}

}  // namespace
}  // namespace sim2d
