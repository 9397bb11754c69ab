// SPDX-License-Identifier: BSD-3-Clause
// Reads a run folder with VTK's own readers: what ParaView and the renderer rely on must hold in every file
// that a list names, also in the folder of a run that failed. The folder comes in HFRAC_RUN_FOLDER.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Entry {
  double time;
  std::filesystem::path file;
};

std::filesystem::path run_folder() {
  const char* folder = std::getenv("HFRAC_RUN_FOLDER");
  return folder ? folder : "";
}

std::vector<Entry> entries(const std::string& series) {
  std::ifstream stream(run_folder() / (series + ".pvd"));
  std::ostringstream text;
  text << stream.rdbuf();
  const std::string list = text.str();
  const std::regex pattern("timestep=\"([^\"]+)\"[^>]*file=\"([^\"]+)\"");
  std::vector<Entry> found;
  for (std::sregex_iterator match(list.begin(), list.end(), pattern), end; match != end; ++match)
    found.push_back({std::stod((*match)[1]), run_folder() / (*match)[2].str()});
  return found;
}

vtkSmartPointer<vtkUnstructuredGrid> read(const std::filesystem::path& file) {
  const auto output_of = [&](auto& reader) -> vtkSmartPointer<vtkUnstructuredGrid> {
    reader->SetFileName(file.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0UL) << file;
    return reader->GetOutput();
  };
  if (file.extension() == ".vtu") {
    const vtkNew<vtkXMLUnstructuredGridReader> reader;
    return output_of(reader);
  }
  const vtkNew<vtkXMLPUnstructuredGridReader> reader;  // of a list of pieces
  return output_of(reader);
}

/** An array of a series: where it is and how wide. */
struct ArraySpec {
  const char* name;
  int components;
};

void expect_arrays(vtkFieldData* data, vtkIdType items, const std::vector<ArraySpec>& specs) {
  for (const auto& spec : specs) {
    vtkDataArray* array = data->GetArray(spec.name);
    ASSERT_NE(array, nullptr) << spec.name;
    EXPECT_EQ(array->GetNumberOfComponents(), spec.components) << spec.name;
    ASSERT_EQ(array->GetNumberOfTuples(), items) << spec.name;
    for (vtkIdType i = 0; i < items; ++i)
      for (int k = 0; k < spec.components; ++k)
        ASSERT_TRUE(std::isfinite(array->GetComponent(i, k))) << spec.name << " of item " << i;
    const std::string name = spec.name;
    const bool has_unit = name.ends_with("_m") || name.ends_with("_Pa") || name.ends_with("_N");
    EXPECT_TRUE(!has_unit || array->GetInformation()->Has(vtkDataArray::UNITS_LABEL())) << spec.name;
  }
}

/** Calls `check` with every grid of a series, after the checks that hold for all. */
template <class Check>
void for_each_grid(const std::string& series, Check check) {
  const auto list = entries(series);
  ASSERT_FALSE(list.empty()) << series;
  double before = -1.0;
  for (const auto& entry : list) {
    SCOPED_TRACE(entry.file.string());
    ASSERT_TRUE(std::filesystem::exists(entry.file));
    EXPECT_GT(entry.time, before);
    before = entry.time;
    const auto grid = read(entry.file);
    ASSERT_NE(grid->GetFieldData()->GetArray("TimeValue"), nullptr);
    EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), entry.time);
    ASSERT_NE(grid->GetFieldData()->GetArray("step"), nullptr);
    ASSERT_NE(grid->GetFieldData()->GetArray("well_pressure_Pa"), nullptr);
    check(*grid);
  }
}

TEST(RunFolder, DiscsAreVerticesWithTheirState) {
  for_each_grid("discs", [](vtkUnstructuredGrid& grid) {
    EXPECT_GT(grid.GetNumberOfPoints(), 0);
    EXPECT_EQ(grid.GetNumberOfCells(), grid.GetNumberOfPoints());
    EXPECT_EQ(grid.GetCellType(0), VTK_VERTEX);
    EXPECT_EQ(grid.GetPoints()->GetDataType(), VTK_DOUBLE);
    expect_arrays(grid.GetPointData(), grid.GetNumberOfPoints(),
                  {{"radius_m", 1},
                   {"displacement_m", 3},
                   {"rotation_rad", 1},
                   {"stress_Pa", 3},
                   {"intact_bonds", 1},
                   {"disc_id", 1}});
    EXPECT_GT(grid.GetPointData()->GetArray("radius_m")->GetRange()[0], 0.0);
  });
}

TEST(RunFolder, BondsAreLinesBetweenDiscCentres) {
  for_each_grid("bonds", [](vtkUnstructuredGrid& grid) {
    EXPECT_GT(grid.GetNumberOfCells(), 0);
    EXPECT_EQ(grid.GetCellType(0), VTK_LINE);
    expect_arrays(grid.GetCellData(), grid.GetNumberOfCells(),
                  {{"state", 1},
                   {"normal_force_N", 1},
                   {"shear_force_N", 1},
                   {"moment_N_m", 1},
                   {"gap_m", 1},
                   {"aperture_m", 1},
                   {"flow_m2_per_s", 1},
                   {"bond_id", 1}});
  });
}

TEST(RunFolder, CracksAreLinesAcrossTheirContact) {
  vtkIdType before = 0;
  for_each_grid("cracks", [&before](vtkUnstructuredGrid& grid) {
    EXPECT_GE(grid.GetNumberOfCells(), before) << "the crack log only grows";
    before = grid.GetNumberOfCells();
    EXPECT_EQ(grid.GetNumberOfPoints(), 2 * before);
    expect_arrays(grid.GetCellData(), before,
                  {{"mode", 1},
                   {"aperture_m", 1},
                   {"pressure_Pa", 1},
                   {"time_s", 1},
                   {"step", 1},
                   {"fracture", 1},
                   {"crack_id", 1}});
  });
}

TEST(RunFolder, CracksLieAcrossTheBondsThatBroke) {
  const auto crack_list = entries("cracks"), bond_list = entries("bonds");
  ASSERT_FALSE(crack_list.empty() || bond_list.empty());
  // A run that was killed between two files has one snapshot more in the series written first.
  const size_t last = std::min(crack_list.size(), bond_list.size()) - 1;
  const auto cracks = read(crack_list[last].file), bonds = read(bond_list[last].file);
  vtkDataArray* state = bonds->GetCellData()->GetArray("state");
  vtkIdType broken = 0;
  for (vtkIdType i = 0; i < bonds->GetNumberOfCells(); ++i) broken += state->GetComponent(i, 0) != 0.0;
  EXPECT_EQ(cracks->GetNumberOfCells(), broken);
}

TEST(RunFolder, JointsAreLinesIfThereAreAny) {
  std::ifstream history(run_folder() / "history.csv");
  std::string columns;
  std::getline(history, columns);
  const bool none = columns.find("joint_slipped_length_m") == std::string::npos;
  ASSERT_EQ(entries("joints").empty(), none);
  if (none) return;
  vtkIdType contacts = -1;
  for_each_grid("joints", [&contacts](vtkUnstructuredGrid& grid) {
    const vtkIdType count = grid.GetNumberOfCells();
    EXPECT_GT(count, 0);
    EXPECT_TRUE(contacts < 0 || count == contacts) << "a joint keeps its contacts";
    contacts = count;
    EXPECT_EQ(grid.GetCellType(0), VTK_LINE);
    EXPECT_EQ(grid.GetNumberOfPoints(), 2 * count);
    expect_arrays(grid.GetCellData(), count,
                  {{"number", 1},
                   {"bond", 1},
                   {"state", 1},
                   {"opening_m", 1},
                   {"mechanical_aperture_m", 1},
                   {"hydraulic_aperture_m", 1},
                   {"slip_m", 1},
                   {"total_slip_m", 1},
                   {"normal_stress_Pa", 1},
                   {"shear_stress_Pa", 1},
                   {"pressure_Pa", 1},
                   {"contact_id", 1}});
    EXPECT_GE(grid.GetCellData()->GetArray("state")->GetRange()[0], 0.0);
    EXPECT_LE(grid.GetCellData()->GetArray("state")->GetRange()[1], 3.0);
  });
}

TEST(RunFolder, DomainsArePolygonsThatDoNotFoldOver) {
  for_each_grid("flow", [](vtkUnstructuredGrid& grid) {
    ASSERT_GT(grid.GetNumberOfCells(), 0);
    expect_arrays(grid.GetCellData(), grid.GetNumberOfCells(),
                  {{"pressure_Pa", 1}, {"volume_m2", 1}, {"domain_id", 1}, {"kind", 1}});
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
      ASSERT_EQ(grid.GetCellType(i), VTK_POLYGON);
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      grid.GetCellPoints(i, count, corners);
      ASSERT_GE(count, 3);
      double area = 0.0, a[3], b[3];
      for (vtkIdType k = 0; k < count; ++k) {
        grid.GetPoint(corners[k], a);
        grid.GetPoint(corners[(k + 1) % count], b);
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
      ASSERT_GT(area, 0.0) << "domain " << grid.GetCellData()->GetArray("domain_id")->GetComponent(i, 0);
    }
  });
}

}  // namespace
