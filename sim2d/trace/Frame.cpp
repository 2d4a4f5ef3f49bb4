#include "sim2d/trace/Frame.h"

namespace sim2d {
namespace {

template <class Columns>
bool areEqualColumns(const Columns& a, const Columns& b) {
  bool same = true;
  Columns::eachColumn([&](auto column) { same = same && a.*column == b.*column; });
  return same;
}

}  // namespace

bool operator==(const BodyColumns& a, const BodyColumns& b) {
  return areEqualColumns(a, b);
}

bool operator==(const HumanColumns& a, const HumanColumns& b) {
  return areEqualColumns(a, b);
}

bool operator==(const ForceColumns& a, const ForceColumns& b) {
  return areEqualColumns(a, b);
}

bool operator==(const Event& a, const Event& b) {
  return a.kind == b.kind && a.id == b.id && a.hasId == b.hasId && a.other == b.other &&
         a.hasOther == b.hasOther && a.text == b.text;
}

}  // namespace sim2d
