// SPDX-License-Identifier: BSD-3-Clause
// What the run-folder writer codes, VTK's reader and ours decode to the same numbers, in every packing.
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "run/vtu_writer.hpp"
#include "web/server/grid.hpp"
#include "web/server/guards.hpp"

namespace {

namespace fs = std::filesystem;
using namespace hfrac::run;

class Writer : public testing::TestWithParam<std::tuple<Compression, size_t>> {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() / ("hfrac-writer-" + hfrac::web::random_key() + ".vtu");
  }
  void TearDown() override { fs::remove(file_); }

  static Compression compression() { return std::get<0>(GetParam()); }

  /** Triangles side by side; the size decides how many blocks an array has. */
  static VtuGrid sample(size_t cells) {
    VtuGrid grid;
    grid.cell_type = CellType::polygon;
    grid.offsets = even_offsets(cells, 3);
    std::vector<double> pressure, tensor;
    for (size_t i = 0; i < 3 * cells; ++i) {
      grid.positions.insert(grid.positions.end(),
                            {0.1 * static_cast<double>(i), std::sin(static_cast<double>(i))});
      grid.connectivity.push_back(static_cast<int32_t>(3 * cells - 1 - i));
      tensor.push_back(1e7 * std::cos(static_cast<double>(i)));
    }
    for (size_t i = 0; i < cells; ++i) pressure.push_back(25e6 + static_cast<double>(i * i % 1000));
    grid.cell_data.push_back(floats("pressure_Pa", "Pa", pressure));
    grid.cell_data.push_back(exact("time_s", "s", pressure));
    grid.cell_data.push_back(whole("domain_id", std::vector<int32_t>(cells, 7)));
    grid.cell_data.push_back(floats("stress_Pa", "Pa", tensor, {"xx", "yy", "xy"}));
    return grid;
  }

  void write(const VtuGrid& grid) const {
    const Moment moment{0.125, 7, {}};
    const std::string text = encode(grid, moment, compression());
    EXPECT_EQ(text, encode(grid, moment, compression())) << "two files of one grid differ";
    std::ofstream(file_, std::ios::binary) << text;
  }

  fs::path file_;
};

TEST_P(Writer, IsReadByVtk) {
  const size_t cells = std::get<1>(GetParam());
  const VtuGrid grid = sample(cells);
  write(grid);
  const vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file_.c_str());
  reader->Update();
  auto* read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfCells(), static_cast<vtkIdType>(cells));
  EXPECT_EQ(read->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 0.125);
  EXPECT_EQ(read->GetFieldData()->GetArray("step")->GetComponent(0, 0), 7.0);
  for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i) {
    ASSERT_EQ(read->GetPoint(i)[0], grid.positions[static_cast<size_t>(2 * i)]);
    ASSERT_EQ(read->GetPoint(i)[1], grid.positions[static_cast<size_t>(2 * i + 1)]);
    ASSERT_EQ(read->GetPoint(i)[2], 0.0);
  }
  for (const VtuArray& array : grid.cell_data) {
    auto* values = read->GetCellData()->GetArray(array.name.c_str());
    ASSERT_NE(values, nullptr) << array.name;
    if (!array.unit.empty()) {
      EXPECT_EQ(array.unit, values->GetInformation()->Get(vtkDataArray::UNITS_LABEL()));
    }
    const int width = values->GetNumberOfComponents();
    for (int i = 0; i < width && width > 1; ++i)
      EXPECT_STREQ(values->GetComponentName(i), array.components[static_cast<size_t>(i)]);
    std::visit(
        [&](const auto& written) {
          ASSERT_EQ(static_cast<size_t>(values->GetNumberOfValues()), written.size());
          for (size_t i = 0; i < written.size(); ++i) {
            const auto at = static_cast<vtkIdType>(i);
            ASSERT_EQ(values->GetComponent(at / width, static_cast<int>(at % width)),
                      static_cast<double>(written[i]));
          }
        },
        array.values);
  }
  for (vtkIdType i = 0; i < read->GetNumberOfCells(); ++i) {
    EXPECT_EQ(read->GetCellType(i), VTK_POLYGON);
    for (vtkIdType j = 0; j < 3; ++j)
      ASSERT_EQ(read->GetCell(i)->GetPointId(static_cast<int>(j)),
                grid.connectivity[static_cast<size_t>(3 * i + j)]);
  }
}

TEST_P(Writer, IsReadByUs) {
  const size_t cells = std::get<1>(GetParam());
  const VtuGrid written = sample(cells);
  write(written);
  const auto read = hfrac::web::read_grid(file_);
  EXPECT_EQ(read->time, 0.125);
  ASSERT_EQ(read->cells, static_cast<int64_t>(cells));
  size_t found = 0;
  for (const auto& array : read->arrays) {
    if (array.name == "corner") {
      EXPECT_EQ(std::get<std::vector<int32_t>>(array.values), written.connectivity);
    }
    for (const auto& one : written.cell_data) {
      if (array.name != one.name) continue;
      ++found;
      EXPECT_EQ(array.unit, one.unit);
      std::visit(
          [&](const auto& values) {
            EXPECT_EQ(std::get<std::decay_t<decltype(values)>>(one.values), values);
          },
          array.values);
    }
  }
  EXPECT_EQ(found, written.cell_data.size());
}

// One block of an array is 2^17 bytes: none, one, one exactly full, several.
INSTANTIATE_TEST_SUITE_P(Codings, Writer,
                         testing::Combine(testing::Values(Compression::zlib, Compression::lz4,
                                                          Compression::none),
                                          testing::Values(0, 1, 32768, 40000)));

}  // namespace
