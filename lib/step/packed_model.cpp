// SPDX-License-Identifier: BSD-3-Clause
#include "step/packed_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.hpp"
#include "model/visit_state.hpp"
#include "state/archive.hpp"
#include "state/seal.hpp"

namespace hfrac {
namespace {

// The hundreds of the format count changes of what stands here, the rest is that of the state.
constexpr SealKind packed_seal{"hfracpak", 100 + image_format,
                               "the model file cannot be used: ", "a model file",
                               "make it anew with hfrac pack, or use the version that made it."};

// An array with its length, all at once.
template <class Archive, class Numbers>
void numbers(Archive& archive, Numbers& values) {
  auto count = static_cast<std::int64_t>(values.size());
  archive.value(count);
  if constexpr (Archive::loading) {
    archive.require(count >= 0 && static_cast<std::uint64_t>(count) <= archive.left() / sizeof values[0]);
    values.resize(static_cast<std::size_t>(count));
  }
  archive.array(values);
}

template <class Archive, class Self>
void visit(Archive& archive, Self& m, bool discs_alone) {
  archive.list(m.options, [](auto& in, auto& option) {
    numbers(in, option.key);
    in.value(option.value);
  });
  for (auto* items : {&m.wells, &m.joints})
    archive.list(*items, [](auto& in, auto& item) { numbers(in, item); });
  auto& p = m.packing;
  for (auto* values : {&p.x, &p.y, &p.radius}) numbers(archive, *values);
  auto& sizes = p.sizes;
  for (auto* value : {&p.residual, &p.mean_radius, &p.mean_overlap, &sizes.fine, &sizes.coarsening,
                      &sizes.growth, &sizes.half_width, &sizes.half_length, &sizes.along.x, &sizes.along.y})
    archive.value(*value);
  const auto place = [](auto& in, auto& at) {
    in.value(at.x);
    in.value(at.y);
  };
  archive.list(sizes.centres, place);
  numbers(archive, m.bonds);
  if (discs_alone) return;
  archive.value(m.rock.modulus);
  archive.value(m.rock.poisson);
  archive.list(m.rock.rim, place);
  archive.list(m.settled, [](auto& in, auto& contact) {
    for (auto* value :
         {&contact.open_before, &contact.slid_before, &contact.locked_normal, &contact.locked_shear})
      in.value(*value);
  });
  numbers(archive, m.state);
}

// A checksum protects against accidents, not against intent.
bool sound(const Packing& packing) {
  const auto finite = [](const Array<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  };
  return !packing.x.empty() && packing.y.size() == packing.x.size() &&
         packing.radius.size() == packing.x.size() && finite(packing.x) && finite(packing.y) &&
         finite(packing.radius) &&
         std::all_of(packing.radius.begin(), packing.radius.end(), [](double r) { return r > 0.0; });
}

bool sound(const std::vector<std::int64_t>& bonds, std::size_t discs) {
  return bonds.size() % 2 == 0 && std::all_of(bonds.begin(), bonds.end(), [&](std::int64_t disc) {
           return disc >= 0 && disc < static_cast<std::int64_t>(discs);
         });
}

}  // namespace

void PackedModel::take_definition(const CaseDefinition& definition) {
  for (const auto& info : option_table()) options.push_back({info.key, get_value(definition.options, info)});
  const auto row = [](const auto& item, const auto& table) {
    std::vector<double> values;
    for (const auto& info : table) values.push_back(get_value(item, info));
    return values;
  };
  for (const auto& well : definition.wells) wells.push_back(row(well, well_option_table()));
  for (const auto& joint : definition.joints) joints.push_back(row(joint, joint_table()));
}

std::vector<std::byte> bytes_of(const PackedModel& model) {
  Counter counter;
  visit(counter, model, false);
  std::vector<std::byte> bytes(seal_size + counter.size());
  Saver saver{std::span<std::byte>(bytes).subspan(seal_size)};
  visit(saver, model, false);
  put_seal(bytes, packed_seal, 0);
  return bytes;
}

PackedModel packed_model(std::span<const std::byte> bytes, bool discs_alone) {
  PackedModel model;
  Loader loader(open_seal(bytes, packed_seal).body);
  try {
    visit(loader, model, discs_alone);
    loader.require((discs_alone || loader.left() == 0) && sound(model.packing) &&
                   sound(model.bonds, model.packing.x.size()));
  } catch (const Error& error) {
    throw Error(error.kind(), std::string(packed_seal.refusal) + "it is damaged.");
  }
  return model;
}

}  // namespace hfrac
