// A face that the sensor sees at a slant is sharp across, however noisy its ranges are: noise runs along the ray.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Frees what lies beside the sharp face of planes of up to 2.5 m² that are seen at 60 degrees or more: the rim and the back of a screen seen
/// from beside it, thick as the screen is where its front is a sheet of millimetres; the front edge of a shelf, what lies on a desk. `noise`:
/// metres along the ray. Clouds without a sensor's position stay as they are.
void keep_sharp_faces(const Cloud& cloud, double noise, Regions& regions, int threads = 1);

}  // namespace scenelore::perception
