#include "sets.hpp"

#include "face_rows.hpp"
#include "point_rows.hpp"
#include "relaxing_rows.hpp"
#include "text.hpp"

namespace validate {

const std::vector<Set>& sets() {
  constexpr bool not_asked = false;
  static const std::vector<Set> all{
      {"wall", read_points, text::tally, text::points, write_plain_points},
      {"wall, unseen", read_unseen_points, text::unseen_tally, text::unseen_points, write_plain_points, not_asked},
      {"pairs", read_pairs, text::pair_tally, text::pairs, write_plain_points},
      {"spheres", read_spheres, text::sphere_tally, text::sphere_points, write_plain_points},
      {"hollow spheres", read_hollow, text::hollow_tally, text::hollow_points, write_plain_points},
      {"half-spaces", read_half_spaces, text::half_space_tally, text::half_space_points, write_plain_points},
      {"lossy", read_lossy, text::lossy_tally, text::lossy_points, write_plain_points},
      {"relaxing", read_relaxing, text::relaxing_tally, text::relaxing_points, write_relaxing_points},
      {"faces", read_faces, text::face_tally, text::face_points, write_face_points},
      {"vibrating", read_vibrating, text::vibrating_tally, text::vibrating_points, write_plain_points, not_asked}};
  return all;
}

}  // namespace validate
