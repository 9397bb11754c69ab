// SPDX-License-Identifier: BSD-3-Clause
#include "solid/smooth_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hfrac {
namespace {

constexpr double widest_gap = 4.0;       // mean radii between contacts: beyond, the joint runs through a hole
constexpr double smallest_piece = 0.01;  // mean radii

Vec2 turned(Vec2 v) {
  return {-v.y, v.x};
}

// A bond and where it meets a joint, or if one of its discs moved to the other side the foot of its middle; the discs on the joint's left and
// right, and their feet on it. All along the joint [m].
struct Crossing {
  std::int64_t bond;
  double at;
  std::int32_t disc[2];
  double foot[2];
};
Crossing crossing_of(const Assembly& a, std::int64_t e, Vec2 from, Vec2 along) {
  Crossing c{};
  const Vec2 p{a.x[a.first[e]], a.y[a.first[e]]}, bond{a.dx(e), a.dy(e)};
  c.bond = e;
  bool first_left = cross(along, p - from) > 0.0;
  if (first_left == (cross(along, p + bond - from) > 0.0)) {
    c.at = dot(a.contact_point(e) - from, along);
    if (a.smooth.moved_over(a.first[e]) >= 0) first_left = !first_left;
  } else {
    c.at = dot(p + (cross(from - p, along) / cross(bond, along)) * bond - from, along);
  }
  c.disc[0] = first_left ? a.first[e] : a.second[e];
  c.disc[1] = first_left ? a.second[e] : a.first[e];
  for (int side = 0; side < 2; ++side)
    c.foot[side] = dot(Vec2{a.x[c.disc[side]], a.y[c.disc[side]]} - from, along);
  return c;
}

struct Piece {
  std::int64_t bond;
  bool first_left;
  double begin, end;
};
Piece piece_of(const Assembly& a, const Crossing& c, double begin, double end) {
  return {c.bond, c.disc[0] == a.first[c.bond], begin, end};
}

// Takes idle contacts between two others out of `met`, and gives them pieces of no length.
std::vector<Piece> take_idle(const Assembly& a, std::vector<Crossing>& met,
                             const std::vector<std::int64_t>& idle) {
  std::vector<Piece> pieces;
  std::vector<Crossing> left;
  for (std::size_t m = 0; m < met.size(); ++m) {
    const bool out = std::binary_search(idle.begin(), idle.end(), met[m].bond) && !left.empty() &&
                     m + 1 < met.size() &&
                     met[m + 1].at - left.back().at <= widest_gap * a.mean_radius_of(met[m].bond);
    if (out)
      pieces.push_back(piece_of(a, met[m], met[m].at, met[m].at));
    else
      left.push_back(met[m]);
  }
  met = std::move(left);
  return pieces;
}

// Shares the joint out. Going along it, from one contact to the next the disc on one side changes, or on both: there ends the
// first disc's face, between its foot and the next one's as their radii are. Faces that would begin before they end are
// cut at their mean. At its ends the joint reaches as far as both discs' faces. So each disc is pressed about evenly around its foot, whatever way its contacts look.
std::vector<Piece> pieces_of(const Assembly& a, std::vector<Crossing>& met, double length,
                             const std::vector<std::int64_t>& idle) {
  std::sort(met.begin(), met.end(), [](const Crossing& p, const Crossing& q) {
    return p.at != q.at ? p.at < q.at : p.bond < q.bond;
  });
  std::vector<Piece> pieces = take_idle(a, met, idle);
  const auto rim = [&](const Crossing& c, int side, double way) {
    return c.foot[side] + way * a.radius[c.disc[side]];
  };
  for (std::size_t first = 0; first < met.size();) {
    std::size_t last = first;
    while (last + 1 < met.size() &&
           met[last + 1].at - met[last].at <= widest_gap * a.mean_radius_of(met[last].bond))
      ++last;
    struct Cut {
      double at, count;
    };
    std::vector<Cut> cuts;  // each of one or several contacts' ends
    for (std::size_t m = first; m < last; ++m) {
      double sum = 0.0, count = 0.0;
      for (int side = 0; side < 2; ++side) {
        const auto d = met[m].disc[side], next = met[m + 1].disc[side];
        if (d == next) continue;
        sum += met[m].foot[side] +
               (met[m + 1].foot[side] - met[m].foot[side]) * a.radius[d] / (a.radius[d] + a.radius[next]);
        count += 1.0;
      }
      cuts.push_back({count > 0.0 ? sum / count : 0.5 * (met[m].at + met[m + 1].at), 1.0});
      while (cuts.size() > 1 && cuts[cuts.size() - 2].at > cuts.back().at) {
        const Cut late = cuts.back();
        cuts.pop_back();
        Cut& early = cuts.back();
        early.at = (early.at * early.count + late.at * late.count) / (early.count + late.count);
        early.count += late.count;
      }
    }
    std::vector<double> ends;
    for (const auto& cut : cuts) ends.insert(ends.end(), static_cast<std::size_t>(cut.count), cut.at);
    double begin = std::clamp(std::max(rim(met[first], 0, -1.0), rim(met[first], 1, -1.0)), 0.0, length);
    const double stop = std::clamp(std::min(rim(met[last], 0, 1.0), rim(met[last], 1, 1.0)), begin, length);
    for (std::size_t m = first; m <= last; ++m) {
      const double end = m < last ? std::clamp(ends[m - first], begin, stop) : stop;
      pieces.push_back(piece_of(a, met[m], begin, end));
      begin = end;
    }
    first = last + 1;
  }
  return pieces;
}

JointLaw law_of(const JointOptions& joint, const SmoothJoints& smooth, const Options& o) {
  constexpr double lowest = 1e6,
                   above = 2.0;  // Pa; of the stresses around the model: no joint is seen to bear more
  JointLaw law;
  law.normal_stiffness = joint.normal_stiffness > 0.0 ? joint.normal_stiffness : smooth.normal_stiffness;
  law.shear_stiffness = joint.shear_stiffness > 0.0 ? joint.shear_stiffness : smooth.shear_stiffness;
  law.max_closure = joint.max_closure;
  law.highest = above * std::max({lowest, o.stress_sigma_Hmax, o.stress_sigma_hmin});
  law.tensile_strength = joint.tensile_strength;
  law.cohesion = joint.cohesion;
  law.friction = joint.friction >= 0.0 ? joint.friction : o.contact_friction;
  law.residual_friction = joint.residual_friction;
  law.weakening_slip = joint.weakening_slip;
  law.dilation = std::tan(joint.dilation_angle);
  law.dilation_slip = joint.dilation_slip;
  law.aperture = joint.aperture;
  law.residual_aperture = joint.residual_aperture;
  law.roughness = joint.roughness;
  law.storage = joint.storage;
  law.tensile_factor = joint.tensile_factor;
  law.shear_factor = joint.shear_factor;
  return law;
}

// The motion of the faces at a contact, less what the discs grew by temperature.
struct Motion {
  double opening, slide;
};
Motion motion_of(const Assembly& a, const SmoothContact& c) {
  const auto i = a.first[c.bond], j = a.second[c.bond];
  Vec2 between{a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]};
  if (const double growth = a.factors.growth_of(c.bond); growth != 0.0)
    between = between - (growth / a.length(c.bond)) * Vec2{a.dx(c.bond), a.dy(c.bond)};
  const SettledContact from = a.smooth.settled_of(c);
  return {dot(between, c.normal) + c.opens_by_first * a.rotation[i] + c.opens_by_second * a.rotation[j] -
              from.open_before,
          dot(between, turned(c.normal)) + c.slides_by_first * a.rotation[i] +
              c.slides_by_second * a.rotation[j] - from.slid_before};
}

}  // namespace

void begin_smooth_joints(Assembly& a, const std::vector<JointOptions>& joints,
                         const std::vector<std::int32_t>& joint_of, const std::vector<std::int64_t>& idle,
                         const Options& o) {
  SmoothJoints& smooth = a.smooth;
  const double diameter = 2.0 * a.mean_radius;
  smooth.normal_stiffness = o.smooth_joint_normal_stiffness > 0.0 ? o.smooth_joint_normal_stiffness
                                                                  : o.contact_normal_stiffness / diameter;
  smooth.shear_stiffness = o.smooth_joint_shear_stiffness > 0.0 ? o.smooth_joint_shear_stiffness
                                                                : o.contact_shear_stiffness / diameter;
  std::vector<std::vector<std::int64_t>> crossed(joints.size());
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    if (const auto k = joint_of[static_cast<std::size_t>(e)]; k >= 0)
      crossed[static_cast<std::size_t>(k)].push_back(e);
  }
  std::size_t contacts = 0;
  for (std::size_t k = 0; k < joints.size(); ++k)
    if (is_smooth(JointState{joints[k].state})) contacts += crossed[k].size();
  smooth.contacts.reserve(contacts);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const JointOptions& joint = joints[k];
    const JointLaw law = law_of(joint, smooth, o);
    if (smooth.laws.empty() || smooth.laws.back() != law) smooth.laws.push_back(law);
    smooth.law_number.push_back(static_cast<std::int32_t>(smooth.laws.size()) - 1);
    if (!is_smooth(JointState{joint.state})) continue;
    const Vec2 from{joint.x1, joint.y1}, to{joint.x2, joint.y2};
    smooth.lines.push_back({from, to});
    const double length = norm(to - from);
    const Vec2 along = (1.0 / length) * (to - from);
    std::vector<Crossing> met;
    for (const auto e : crossed[k]) met.push_back(crossing_of(a, e, from, along));
    for (const auto& piece : pieces_of(a, met, length, idle)) {
      const std::int64_t e = piece.bond;
      const auto i = a.first[e], j = a.second[e];
      const Vec2 place = from + 0.5 * (piece.begin + piece.end) * along;
      SmoothContact c{};
      c.bond = static_cast<std::int32_t>(e);
      c.joint = static_cast<std::int32_t>(k);
      c.normal = piece.first_left ? -1.0 * turned(along) : turned(along);
      const Vec2 first_arm = place - Vec2{a.x[i], a.y[i]}, second_arm = place - Vec2{a.x[j], a.y[j]};
      c.opens_by_first = -dot(c.normal, turned(first_arm));
      c.opens_by_second = dot(c.normal, turned(second_arm));
      c.slides_by_first = -dot(turned(c.normal), turned(first_arm));
      c.slides_by_second = dot(turned(c.normal), turned(second_arm));
      c.area = std::max(piece.end - piece.begin, smallest_piece * a.mean_radius_at(place));
      smooth.contacts.push_back(c);
    }
  }
  smooth.sort_lines(diameter);  // one that crosses no bond lies between discs, too
  if (smooth.contacts.empty()) return;
  std::sort(smooth.contacts.begin(), smooth.contacts.end(),
            [](const SmoothContact& p, const SmoothContact& q) { return p.bond < q.bond; });
  smooth.index = BondIndex(
      smooth.contacts.size(), [&](std::size_t k) { return smooth.contacts[k].bond; }, a.bond_count());
  smooth.counted.resize(smooth.contacts.size());
}

namespace {

// The law of a contact, with its stiffnesses as temperature leaves them.
JointLaw law_now(const Assembly& a, const SmoothContact& c) {
  JointLaw law = a.smooth.law_of(c);
  const auto i = a.first[c.bond], j = a.second[c.bond];
  const double stiff = a.thermal.pair_stiffness(i, j);
  law.normal_stiffness *= stiff;
  law.shear_stiffness *= stiff;
  law.residual_friction *= a.thermal.pair_friction(i, j);
  return law;
}

// Closure at which a joint bears a stress (Bandis, Lumsden and Barton 1983).
double closure_under(const JointLaw& law, double stress) {
  if (law.max_closure <= 0.0) return stress / law.normal_stiffness;
  const double bent = std::min(stress, law.highest),
               d = bent / (law.normal_stiffness + bent / law.max_closure);
  return d + (stress - bent) / stiffest(law);
}

}  // namespace

void settle_smooth(Assembly& a, const std::vector<JointStress>& wanted) {
  const auto& contacts = a.smooth.contacts;
  a.smooth.settled.resize(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const SmoothContact& c = contacts[k];
    SettledContact& to = a.smooth.settled[k];
    if (!a.smooth.law_of(c).conducts()) continue;
    const JointLaw law = law_now(a, c);
    const SmoothResponse before = smooth_response(a, c);
    a.slip[c.bond] = 0.0;  // what it slid while nothing pressed it yet
    const double pressed = std::max(0.0, wanted[k].normal);
    to.open_before += before.opening + closure_under(law, pressed);
    to.slid_before +=
        before.slide - (law.shear_stiffness > 0.0 ? wanted[k].shear / law.shear_stiffness : 0.0);
    const SmoothResponse after = smooth_response(a, c);
    to.locked_normal += before.normal - after.normal;
    to.locked_shear += before.shear - after.shear;
  }
}

double smooth_opening(const Assembly& a, const SmoothContact& contact) {
  return motion_of(a, contact).opening;
}

double joint_opening(const Assembly& a, std::int64_t bond) {
  if (a.intact[bond] != 0 || a.joints.joint_of(bond) < 0) return 0.0;
  if (const SmoothContact* contact = a.smooth.of(bond)) {
    return std::max(0.0, smooth_opening(a, *contact));
  }
  const auto i = a.first[bond], j = a.second[bond];
  const double opening = dot({a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}, a.joint_normal(bond));
  return opening > 0.0 ? opening : 0.0;
}

namespace {

// Slip at which friction bears what shear is left, from `slip` towards `slide`:
//   g(s) = sign k_s (slide - s) - mu(s) sigma_n(D(s) - opening) = 0
// Without dilation and weakening g is linear; else Newton's method, halving where it leaves the bracket.
double slipped_to(const JointLaw& law, const Motion& m, double slip, double friction, double sign) {
  if (law.shear_stiffness <= 0.0) return m.slide;
  const auto stress = [&](double s) {
    return closure_stress(law, joint_dilation(law, s).value - m.opening).value;
  };
  if (!law.follows_slip()) return m.slide - sign * friction * stress(slip) / law.shear_stiffness;
  double low = slip, high = m.slide, s = slip;
  constexpr int most = 80;
  constexpr double finest = 1e-15;  // of the way
  for (int round = 0; round < most; ++round) {
    const JointValue mu = joint_friction(law, friction, s), up = joint_dilation(law, s),
                     press = closure_stress(law, up.value - m.opening);
    const double g = sign * law.shear_stiffness * (m.slide - s) - mu.value * press.value;
    const double slope =
        -sign * law.shear_stiffness - mu.slope * press.value - mu.value * press.slope * up.slope;
    (g > 0.0 ? low : high) = s;
    double next = slope != 0.0 ? s - g / slope : low;
    if (std::abs(next - s) <= finest * std::abs(m.slide - slip)) break;
    if ((next - low) * sign <= 0.0 || (high - next) * sign <= 0.0) next = 0.5 * (low + high);
    s = next;
  }
  return s;
}

SmoothResponse respond_by(const JointLaw& law, const SmoothContact& c, bool holds, double slip,
                          const Motion& m, double friction) {
  SmoothResponse r{m.opening, m.slide, 0.0, 0.0, slip, 0.0, 0.0, 0.0, 0.0};
  const double kn = c.area * law.normal_stiffness, ks = c.area * law.shear_stiffness;
  if (holds) {
    const JointValue press = closure_stress(law, -m.opening);
    r.normal = m.opening < 0.0 ? -c.area * press.value : kn * m.opening;
    r.normal_stiffness = m.opening < 0.0 ? c.area * press.slope : kn;
    r.shear = ks * m.slide;
    r.shear_stiffness = ks;
    return r;
  }
  JointValue press = closure_stress(law, joint_dilation(law, slip).value - m.opening);
  const double trial = ks * (m.slide - slip),
               limit = joint_friction(law, friction, slip).value * c.area * press.value;
  r.shear = trial;
  if (press.slope > 0.0) r.shear_stiffness = ks;
  r.normal = -c.area * press.value;
  r.normal_stiffness = c.area * press.slope;
  r.shear_limit = limit;
  if (std::abs(trial) <= limit) return r;
  const double sign = std::copysign(1.0, trial);
  r.slipped = slipped_to(law, m, slip, friction, sign);
  const JointValue mu = joint_friction(law, friction, r.slipped), up = joint_dilation(law, r.slipped);
  press = closure_stress(law, up.value - m.opening);
  r.normal = -c.area * press.value;
  r.shear_limit = mu.value * c.area * press.value;
  r.shear = sign * r.shear_limit;
  // By the slip's own change, d slip = (k_s d slide + sign mu sigma' d opening) / `falls`; a contact that weakens faster than its
  // stiffness follows is given a tenth of that.
  const double falls =
      std::max(0.1 * law.shear_stiffness,
               law.shear_stiffness + sign * (mu.slope * press.value + mu.value * press.slope * up.slope));
  const double by_slide = law.shear_stiffness > 0.0 ? law.shear_stiffness / falls : 1.0,
               by_opening = law.shear_stiffness > 0.0 ? sign * mu.value * press.slope / falls : 0.0;
  r.shear_stiffness = ks * (1.0 - by_slide);
  r.shear_by_opening = -ks * by_opening;
  r.normal_stiffness = c.area * press.slope * (1.0 - up.slope * by_opening);
  r.normal_by_slide = -c.area * press.slope * up.slope * by_slide;
  return r;
}

}  // namespace

double joint_friction(const SmoothJoints& smooth, const JointLaw& law) {
  constexpr double sticks = 1e9;  // friction that no contact overcomes
  return smooth.held && law.conducts() ? sticks : law.friction;
}

SmoothResponse smooth_response(const Assembly& a, const SmoothContact& c) {
  const double heated = a.thermal.pair_friction(a.first[c.bond], a.second[c.bond]);
  return respond_by(law_now(a, c), c, a.intact[c.bond] != 0, a.slip[c.bond], motion_of(a, c),
                    joint_friction(a.smooth, a.smooth.law_of(c)) * heated);
}

namespace {
// Pa: what the joint gives, or the rock's bonds times their factor.
double strength_of(double given, double per_radius, double factor) {
  return given > 0.0 ? given : 0.5 * per_radius * factor;
}
}  // namespace

BondView view_smooth(const Assembly& a, const SmoothContact& c) {
  const SmoothResponse r = smooth_response(a, c);
  const SettledContact locked = a.smooth.settled_of(c);
  const bool holds = a.intact[c.bond] != 0;
  const JointLaw law = law_now(a, c);
  const double kn = c.area * law.normal_stiffness, ks = c.area * law.shear_stiffness;
  BondView v{};
  v.gap = r.opening;
  v.shear = r.slide;
  v.normal = c.normal;
  v.first_arm = c.first_arm();
  v.second_arm = c.second_arm();
  const double closure = (holds ? 0.0 : joint_dilation(law, r.slipped).value) - r.opening;
  double energy = r.normal > 0.0 ? 0.5 * r.normal * r.normal / kn : c.area * closure_energy(law, closure);
  if (ks > 0.0) energy += 0.5 * r.shear * r.shear / ks;
  energy += locked.locked_normal * r.opening + locked.locked_shear * r.slide;
  if (!holds) {
    v.contact_normal = -(r.normal + locked.locked_normal);
    v.contact_shear = r.shear + locked.locked_shear;
    v.contact_energy = energy;
    v.shear_excess = v.tensile_excess = 0.0;
    return v;
  }
  v.bond_normal = r.normal + locked.locked_normal;
  v.bond_shear = r.shear + locked.locked_shear;
  v.bond_energy = energy;
  const bool differ = !a.factors.empty();
  const double tensile = strength_of(law.tensile_strength, a.tensile_per_radius,
                                     differ ? a.factors.tensile[c.bond] : law.tensile_factor) *
                         c.area,
               shearing = strength_of(law.cohesion, a.shear_per_radius,
                                      differ ? a.factors.shear[c.bond] : law.shear_factor) *
                              c.area +
                          law.friction * a.thermal.pair_friction(a.first[c.bond], a.second[c.bond]) *
                              std::max(0.0, -r.normal);
  v.tensile_excess = tensile > 0.0 ? r.normal / tensile : (r.normal >= 0.0 ? 1.0 : 0.0);
  v.shear_excess = shearing > 0.0 ? std::abs(r.shear) / shearing : 1.0;
  return v;
}

const SmoothContact* farthest_slide(const Assembly& a, double& slide, std::int64_t first_disc,
                                    std::int64_t last_disc) {
  const SmoothContact* farthest = nullptr;
  slide = 0.0;
  for (const auto& contact : a.smooth.contacts) {
    if (a.first[contact.bond] < first_disc || a.first[contact.bond] >= last_disc) continue;
    const double now = std::abs(motion_of(a, contact).slide);
    if (farthest != nullptr && now <= slide) continue;
    farthest = &contact;
    slide = now;
  }
  return farthest;
}

SmoothForces answer_of(const Assembly& a, const SmoothContact& c, double& slip, double& friction) {
  const SmoothResponse r = smooth_response(a, c);
  const JointLaw& law = a.smooth.law_of(c);
  // What slipping turns into heat: the work of friction less what lifts the faces.
  const double lifted = joint_dilation(law, r.slipped).value - joint_dilation(law, slip).value;
  friction += std::abs(r.shear * (r.slipped - slip)) + r.normal * lifted;
  slip = r.slipped;
  const SettledContact locked = a.smooth.settled_of(c);
  const double normal = r.normal + locked.locked_normal, shear = r.shear + locked.locked_shear;
  const Vec2 force = normal * c.normal + shear * turned(c.normal);
  const auto i = a.first[c.bond], j = a.second[c.bond];
  // Once the faces have moved apart the two forces lie on two lines: what that turns is shared, so that a pair turns nothing.
  const double couple = 0.5 * cross(Vec2{a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}, force);
  return {force.x, force.y, couple - (c.opens_by_first * normal + c.slides_by_first * shear),
          couple - (c.opens_by_second * normal + c.slides_by_second * shear)};
}

bool kernels_know(const Assembly& a) {
  return a.thermal.empty() && a.strength_scale.empty() &&
         std::none_of(a.smooth.laws.begin(), a.smooth.laws.end(),
                      [](const JointLaw& law) { return law.follows_slip(); });
}

Array<SmoothLaw> laws_for_kernels(const Assembly& a) {
  Array<SmoothLaw> rows;
  for (const auto& law : a.smooth.laws) {
    const bool bends = law.max_closure > 0.0;
    rows.push_back({law.normal_stiffness, law.shear_stiffness, bends ? 1.0 / law.max_closure : 0.0,
                    bends ? last_closure(law) : std::numeric_limits<double>::max(),
                    joint_friction(a.smooth, law),
                    strength_of(law.tensile_strength, a.tensile_per_radius, law.tensile_factor),
                    strength_of(law.cohesion, a.shear_per_radius, law.shear_factor), law.friction});
  }
  return rows;
}

// As stable_step.cpp does it for the other bonds: row sums of |K|, that of the rotation times the radius.
void add_smooth_stiffness(const Assembly& a, std::span<double> row_x, std::span<double> row_y,
                          std::span<double> row_rotation) {
  for (const auto& c : a.smooth.contacts) {
    const auto i = a.first[c.bond], j = a.second[c.bond];
    const JointLaw law = law_now(a, c);
    const double kn = c.area * stiffest(law), ks = c.area * law.shear_stiffness;
    const double nx = std::abs(c.normal.x), ny = std::abs(c.normal.y), both = std::abs(kn - ks) * nx * ny;
    const double opens = std::abs(c.opens_by_first) / a.radius[i] + std::abs(c.opens_by_second) / a.radius[j],
                 slides =
                     std::abs(c.slides_by_first) / a.radius[i] + std::abs(c.slides_by_second) / a.radius[j];
    for (const auto d : {i, j}) {
      const double opens_by = std::abs(d == i ? c.opens_by_first : c.opens_by_second),
                   slides_by = std::abs(d == i ? c.slides_by_first : c.slides_by_second);
      row_x[d] += 2.0 * (kn * nx * nx + ks * ny * ny + both) + kn * nx * opens + ks * ny * slides;
      row_y[d] += 2.0 * (kn * ny * ny + ks * nx * nx + both) + kn * ny * opens + ks * nx * slides;
      row_rotation[d] += a.radius[d] * (2.0 * (kn * opens_by + ks * slides_by) * (nx + ny) +
                                        kn * opens_by * opens + ks * slides_by * slides);
    }
  }
}

}  // namespace hfrac
