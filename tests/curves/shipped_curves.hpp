// The curves that the tests share: facts from public sources, each named.
#pragma once

#include <string>
#include <vector>

#include "curves/nurbs_curve.hpp"

namespace kerf::curves::testing {

struct NamedCurve {
  std::string name;
  NurbsData data;
};

const std::vector<NamedCurve>& shipped_curves();
const NurbsData& shipped_curve(const std::string& name);

}  // namespace kerf::curves::testing
