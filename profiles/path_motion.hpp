// One instant of motion along a path.
#pragma once

namespace kerf::profiles {

struct PathMotion {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
};

}  // namespace kerf::profiles
