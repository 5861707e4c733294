#include "find_regions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "absorb.hpp"
#include "assign.hpp"
#include "bridge_pieces.hpp"
#include "clutter.hpp"
#include "earlier_regions.hpp"
#include "face_model.hpp"
#include "finer_regions.hpp"
#include "flush_faces.hpp"
#include "front_edges.hpp"
#include "grow.hpp"
#include "limits.hpp"
#include "merge.hpp"
#include "part_gaps.hpp"
#include "part_outlines.hpp"
#include "rejoin.hpp"
#include "scale.hpp"
#include "scenelore/perception/memory.hpp"
#include "seen_from.hpp"
#include "sharp_faces.hpp"
#include "support.hpp"
#include "thin_objects.hpp"
#include "transfer.hpp"

namespace scenelore::perception {
namespace {

constexpr int kLevels = 3;              // voxels of 1, 2 and 4 times the finest size
constexpr int kFewestToGrow = 12;       // points of a region while it is still growing

// Points of a voxel at most that planes are found by: they tell as much as all, to the noise over their square root. A
// scene of few voxels is one of small things, which need more.
constexpr std::int64_t kFewestSampled = 8, kMostSampled = 64, kWantedSample = 300'000;

// Exact planes in a cloud that is not: where distances are rounded, each step of them is one, across the line of sight. Large ones are surfaces
// that stand so.
constexpr double kLargeStep = 0.5;  // m²

// A region less likely than this is no face of the scene. Of large ones, which are somebody's walls even where they bend, only what is
// hardly any, and of those that outlines parted: a desk beside another one looks like a piece of it. What
// is looked at for want of better is rather none.
constexpr double kFace = 0.3, kDoubtfulFace = 0.4, kLargeFace = 0.1, kLarge = 2;  // m²

/// Voxels beyond this are those of a cloud that is not in metres or far too sparse for what is centimetres thick.
constexpr double kCoarsestForThings = 0.5;

/// The planes that hold points, most points first.
std::vector<PlaneFit> by_size(const std::vector<PlaneFit>& planes) {
  std::vector<PlaneFit> result;
  std::copy_if(planes.begin(), planes.end(), std::back_inserter(result), [](const PlaneFit& p) { return p.count > 0; });
  std::stable_sort(result.begin(), result.end(), [](const PlaneFit& a, const PlaneFit& b) { return a.count > b.count; });
  return result;
}

/// One segmentation under way.
class Finder {
 public:
  Finder(const Cloud& cloud, const PerceptionOptions& options, FaceQuestions* questions)
      : cloud_(cloud), options_(options), questions_(questions), threads_(options.threads) {
    begin("voxels");
    voxels_ = voxelise_to_scale(cloud, threads_);
    found_.voxel = voxels_.scale.voxel;
    found_.spacing = voxels_.scale.spacing;
    begin("growing");
    grow_finest(options.parameters);
    pyramid_ = make_pyramid(voxels_.grid, threads_);
    begin("sample");
    const auto voxels = static_cast<std::int64_t>(std::max<std::size_t>(1, voxels_.grid.count()));
    sample_ = take_sample(cloud_, voxels_, std::clamp(kWantedSample / voxels, kFewestSampled, kMostSampled), threads_);
  }

  FoundRegions run();

 private:
  void begin(std::string_view stage) const {
    if (options_.on_stage) options_.on_stage(stage);
  }
  void grow_finest(const SegmentationParameters& parameters);
  void grow_coarser();
  void merge();
  void assign();
  [[nodiscard]] std::vector<double> noise_by_region(double least = 0) const { return noise_of_regions(slots_, noise_of_voxel_, least, planes_.size()); }
  [[nodiscard]] std::vector<float> weights_of_sample() const;
  void bridge(const Eigen::Vector3d& up);
  void drop_steps();
  [[nodiscard]] View view(const Eigen::Vector3d& up, std::size_t first) const;
  [[nodiscard]] std::vector<std::int32_t> regions_of_sample() const { return regions_of_points(slots_, slot_of_point_); }
  [[nodiscard]] Origin origin(std::size_t region) const;
  void judge(const Eigen::Vector3d& up, std::size_t first);
  void find_finer_faces(const Eigen::Vector3d& up);
  void bring_back_faces(const Eigen::Vector3d& up);
  template <typename Judge>
  void look_closer(bool old_ones_too, Judge judge) {
    transfer(sample_, voxels_.grid, found_.limits, judge, old_ones_too, threads_, slot_of_point_, slots_, planes_);
  }

  const Cloud& cloud_;
  const PerceptionOptions& options_;
  FaceQuestions* questions_;
  int threads_;
  ScaledCloud voxels_;
  FoundRegions found_;
  PointSample sample_;
  std::vector<LocalSurface> surfaces_;  // of the finest voxels
  std::vector<float> noise_of_voxel_;   // metres
  Pyramid pyramid_;
  Slots slots_;
  std::vector<PlaneFit> planes_;
  RegionRange things_;
  std::vector<bool> parted_;                        // by region: its outline was cut
  RegionRange finer_;
  std::size_t brought_back_ = 0;                    // regions from here on
  std::vector<std::vector<std::int32_t>> earlier_;  // regions of the sample at some stages
  std::vector<bool> bridged_;  // by region: goes on across a shadow
  SlotOfPoint slot_of_point_;          // of the sample, at last of the cloud
};

void Finder::grow_finest(const SegmentationParameters& parameters) {
  surfaces_ = local_surfaces(voxels_.grid, threads_);
  const NoiseMap noise = estimate_noise(voxels_.grid, surfaces_, threads_);
  found_.noise = noise.typical;
  found_.limits = derive_limits(parameters, voxels_.scale, noise);
  Growth growth = grow_regions(voxels_.grid, surfaces_, noise, kFewestToGrow);
  slots_ = slots_of_voxels(voxels_.grid, growth.region_of_voxel);
  planes_ = std::move(growth.regions);
  noise_of_voxel_ = noise.of_voxel;
}

/// What is sparse at one scale is a surface at a wider one: grows regions from the points that no plane has yet. A finest
/// voxel's free points are taken together, by the plane of its cube or of one beside it.
void Finder::grow_coarser() {
  begin("coarser growing");
  Coarser free;
  std::vector<std::uint32_t> cube;     // of each finest voxel, on the level at hand
  const auto none = [&](std::size_t v) { return slots_.first[v + 1] - 1; };
  const Moments nothing;
  const auto left = [&](std::size_t v) -> const Moments& { return slots_.region[none(v)] < 0 ? slots_.moments[none(v)] : nothing; };
  for (int level = 1; level < kLevels; ++level) {
    free = coarsened(voxels_.grid, left, threads_);
    cube = free.parent;
    for (int wider = 1; wider < level; ++wider) {
      Coarser next = coarsened(free.grid, threads_);
      for (std::uint32_t& c : cube) {
        if (c != kNoVoxel) c = next.parent[c];
      }
      free = std::move(next);
    }
    const std::vector<LocalSurface> surfaces = local_surfaces(free.grid, threads_);
    const NoiseMap noise = estimate_noise(free.grid, surfaces, threads_);
    const Growth growth = grow_regions(free.grid, surfaces, noise, kFewestToGrow);
    const auto first = static_cast<std::int32_t>(planes_.size());
    planes_.insert(planes_.end(), growth.regions.begin(), growth.regions.end());
    for (std::size_t v = 0; v < voxels_.grid.count(); ++v) {
      if (cube[v] == kNoVoxel) continue;
      double best = 0.5;  // of the tolerance, which is three or four deviations
      for (const std::int32_t n : free.grid.neighbours[cube[v]]) {
        const std::int32_t r = n < 0 ? -1 : growth.region_of_voxel[static_cast<std::size_t>(n)];
        if (r < 0) continue;
        const PlaneFit& plane = growth.regions[static_cast<std::size_t>(r)];
        const double d = std::sqrt(slots_.moments[none(v)].mean_squared_distance(plane)) / tolerance(plane, found_.limits);
        if (d < best) best = d, slots_.region[none(v)] = first + r;
      }
    }
  }
  refit(slots_, planes_);
}

/// A pass over the sample: each point goes to the nearest of the planes around it.
void Finder::assign() {
  begin("assignment");
  AssignRule rule;
  rule.unit = rule.reach = tolerances(planes_, found_.limits);
  const Candidates candidates = candidates_around(voxels_.grid, slots_, planes_, rule.reach, found_.limits.max_neighbours, threads_);
  slots_ = {};  // before there are others
  slots_ = assign_points(sample_.by_voxel, voxels_.grid, candidates, planes_, rule, threads_, slot_of_point_);
  refit(slots_, planes_);
}

/// Pieces of one plane become one; what a larger plane explains goes to it.
void Finder::merge() {
  begin("merging");
  const double least_noise = found_.limits.plane_distance_given ? found_.limits.max_plane_distance / 3 : 0;
  merge_regions(pyramid_, noise_by_region(least_noise), slots_, planes_);
  absorb_fragments(voxels_.grid, pyramid_, found_.limits, slots_, planes_);
}

/// For how many points of the cloud each one of the sample stands.
std::vector<float> Finder::weights_of_sample() const {
  std::vector<float> weights;
  weights.reserve(sample_.points.size());
  for (const std::int32_t s : slot_of_point_) {
    const std::uint32_t v = slots_.voxel[s];
    weights.push_back(static_cast<float>(voxels_.fixed[v].n) / static_cast<float>(sample_.by_voxel.count(v)));
  }
  return weights;
}

/// Pieces of tables, walls and fronts become one across the shadows of what stands there; things on tables stay what they are.
void Finder::bridge(const Eigen::Vector3d& up) {
  Regions regions{regions_of_points(slots_, slot_of_point_), planes_};
  for (std::size_t r = 0; r < planes_.size(); ++r) {
    if (things_.hold(r) && std::abs(planes_[r].normal.dot(up)) > kLevel) regions.planes[r] = PlaneFit();
  }
  const std::vector<std::int32_t> into =
      bridge_pieces(sample_.cloud, up, found_.limits, noise_by_region(), regions);
  bridged_.assign(planes_.size(), false);
  for (std::size_t r = 0; r < into.size(); ++r) {
    if (into[r] != static_cast<std::int32_t>(r)) bridged_[static_cast<std::size_t>(into[r])] = true;
  }
  for (std::int32_t& r : slots_.region) {
    if (r >= 0) r = into[static_cast<std::size_t>(r)];
  }
  refit(slots_, planes_);
}

/// Frees what only the sensor's rounding made planar.
void Finder::drop_steps() {
  if (found_.noise < 5 * kExactDeviation) return;
  for (std::int32_t& r : slots_.region) {
    if (r >= 0 && planes_[r].rmse() < kExactDeviation && planes_[r].spread_area() < kLargeStep) r = -1;
  }
  refit(slots_, planes_);
}

/// At what slant the sensor saw each region from `first` on, by some of its points, and how these scatter.
View Finder::view(const Eigen::Vector3d& up, std::size_t first) const {
  constexpr std::size_t kSome = 200;
  std::vector<std::int32_t> of_point = regions_of_sample();
  for (std::int32_t& r : of_point) {
    if (r < static_cast<std::int32_t>(first)) r = -1;
  }
  View view{up, found_.noise, {}, scatters(sample_.cloud, of_point, planes_, threads_)};
  for (const std::vector<std::uint32_t>& all : points_of_regions(of_point, planes_.size())) {
    std::vector<std::uint32_t> some;
    for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / kSome) some.push_back(all[k]);
    const Eigen::Vector3d& normal = planes_[view.slant.size()].normal;
    view.slant.push_back(slant_of(sample_.cloud, normal, some).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return view;
}

Origin Finder::origin(std::size_t region) const {
  if (things_.hold(region)) return Origin::thing;
  if (finer_.hold(region)) return Origin::finer;
  return region < brought_back_ ? Origin::surface : Origin::earlier;
}

/// Of the regions from `first` on, gives up what is more likely clutter, a sliver or two faces under one plane; a piece of the plane beside it
/// goes to that one.
void Finder::judge(const Eigen::Vector3d& up, std::size_t first) {
  const std::vector<FaceTraits> traits =
      face_traits(voxels_.grid, surfaces_, noise_by_region(), slots_, planes_, view(up, first), things_, first, threads_);
  if (questions_ != nullptr) {
    questions_->points = sample_.points;
    FaceRound& round = questions_->rounds.emplace_back(FaceRound{first, traits, {}, regions_of_sample()});
    for (std::size_t r = 0; r < planes_.size(); ++r) round.origins.push_back(origin(r));
  }
  std::vector<bool> given_up(planes_.size());
  for (std::size_t r = first; r < planes_.size(); ++r) {
    const Origin from = origin(r);
    const bool doubtful = from == Origin::earlier || from == Origin::finer, part = r < parted_.size() && parted_[r];
    const double least = planes_[r].spread_area() >= kLarge || part ? kLargeFace : doubtful ? kDoubtfulFace : kFace;
    given_up[r] = planes_[r].count > 0 && face_probability(traits[r], from) < least;
  }
  const std::vector<std::int32_t> into = planes_to_rejoin(pyramid_, slots_, planes_, given_up, found_.noise);
  for (std::int32_t& r : slots_.region) {
    if (r >= 0 && given_up[static_cast<std::size_t>(r)]) r = into[static_cast<std::size_t>(r)];
  }
  refit(slots_, planes_);
}

/// In what no plane has there may be faces that are too small for the voxels.
void Finder::find_finer_faces(const Eigen::Vector3d& up) {
  finer_.first = planes_.size();
  look_closer(false, [&](Regions& regions) { grow_finer(sample_.cloud, voxels_.grid.size / 2, kFewestToGrow, found_.limits, threads_, regions); });
  finer_.end = planes_.size();
  drop_steps();
  judge(up, finer_.first);
}

/// Where a region was given up, what it was before may be a face.
void Finder::bring_back_faces(const Eigen::Vector3d& up) {
  for (const std::vector<std::int32_t>& earlier : earlier_) {
    const std::size_t first = planes_.size();
    look_closer(false, [&](Regions& regions) { bring_back(sample_.cloud, earlier, kFewestToGrow, regions); });
    drop_steps();
    judge(up, first);
  }
}

FoundRegions Finder::run() {
  assign();
  earlier_.push_back(regions_of_sample());
  grow_coarser();
  merge();
  assign();
  merge();
  bridge_shadows(found_.limits.max_plane_distance / 3, kLargePlane, voxels_.grid.size, slots_, planes_);
  earlier_.push_back(regions_of_sample());
  begin("clutter");
  drop_clutter(voxels_.grid, slots_, planes_);
  release(voxels_.grid.moments);  // from here on slots have them; made again for the result
  assign();  // what clutter held may belong to what is left
  begin("upright");
  found_.upright = estimate_upright(cloud_, by_size(planes_), options_.up, options_.floor_z);
  const Eigen::Vector3d up = found_.upright.rotation.inverse() * Eigen::Vector3d::UnitZ();
  const bool in_detail = found_.voxel < kCoarsestForThings;
  begin("gaps");
  if (in_detail) look_closer(false, [&](Regions& regions) { part_at_gaps(sample_.cloud, found_.limits, regions, threads_); });
  begin("flush faces");
  const std::size_t flush = planes_.size();
  if (in_detail) look_closer(false, [&](Regions& regions) { part_flush_faces(sample_.cloud, weights_of_sample(), up, regions); });
  const std::size_t supports = planes_.size();
  begin("thin objects");
  if (in_detail) look_closer(true, [&](Regions& regions) { split_thin_objects(sample_.cloud, found_.upright, found_.limits, regions); });
  things_ = {supports, planes_.size()};
  join_level_pieces(pyramid_, up, flush, supports, noise_by_region(), slots_, planes_);
  begin("sharp faces");
  if (in_detail && !found_.limits.plane_distance_given) look_closer(false, [&](Regions& regions) { keep_sharp_faces(sample_.cloud, found_.noise, regions, threads_); });
  begin("outlines");
  if (in_detail) look_closer(false, [&](Regions& regions) { parted_ = part_outlines(sample_.cloud, up, regions); });
  drop_steps();
  begin("faces");
  brought_back_ = planes_.size();
  judge(up, 0);
  if (in_detail) find_finer_faces(up);
  bring_back_faces(up);
  begin("shadows");
  if (in_detail) bridge(up);
  begin("promises");
  pyramid_ = {};  // done with; all points need the room
  release(surfaces_, noise_of_voxel_, earlier_);
  separate_parts(sample_, voxels_.grid, found_.limits, threads_, slot_of_point_, slots_, planes_, bridged_);
  begin("all points");
  spread_from_sample(cloud_, voxels_, sample_, found_.limits, threads_, slot_of_point_, slots_, planes_);
  begin("front edges");
  if (in_detail && !found_.limits.plane_distance_given) free_front_edges(cloud_, found_.noise, threads_, slot_of_point_, slots_, planes_);
  begin("promises");
  static_cast<Settled&>(found_) =
      keep_promises(cloud_, voxels_, sample_, slots_, bridged_, found_.limits, threads_, std::move(slot_of_point_));
  found_.voxels = moments_of_voxels(voxels_.grid, voxels_.fixed, threads_);
  return std::move(found_);
}

}  // namespace

FoundRegions find_regions(const Cloud& cloud, const PerceptionOptions& options, FaceQuestions* questions) {
  check(options.parameters);
  return Finder(cloud, options, questions).run();
}

}  // namespace scenelore::perception
