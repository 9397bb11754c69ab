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
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "run/files.hpp"
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
    for (const int workers : {1, 2, 5})
      EXPECT_EQ(text, encode(grid, moment, compression(), workers)) << "two files of one grid differ";
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

// Pieces of a grid, a list of them, and all of it in one file: the same cells in the same places, to VTK and to us.
TEST(Pieces, OfAListAreOneGrid) {
  const fs::path folder = fs::temp_directory_path() / ("hfrac-pieces-" + hfrac::web::random_key());
  fs::create_directory(folder);
  // Squares that share corners, each with its number.
  constexpr int32_t across = 5;
  const auto squares = [](Part part) {
    VtuGrid grid;
    grid.cell_type = CellType::polygon;
    for (int32_t j = 0; j <= across; ++j)
      for (int32_t i = 0; i <= across; ++i) grid.positions.insert(grid.positions.end(), {1.0 * i, 0.5 * j});
    std::vector<int32_t> number;
    const auto range = part.of(static_cast<size_t>(across) * across);
    for (int32_t c = range.first; c < range.last; ++c) {
      const int32_t corner = c / across * (across + 1) + c % across;
      grid.connectivity.insert(grid.connectivity.end(),
                               {corner, corner + 1, corner + across + 2, corner + across + 1});
      number.push_back(c);
    }
    grid.offsets = even_offsets(number.size(), 4);
    grid.cell_data.push_back(whole("number", number));
    keep_used_points(grid);
    return grid;
  };
  const auto corners_of = [](const hfrac::web::Grid& grid) {
    std::vector<float> corners;
    std::vector<float> place;
    std::vector<int32_t> corner;
    for (const auto& array : grid.arrays) {
      if (array.name == "position") place = std::get<std::vector<float>>(array.values);
      if (array.name == "corner") corner = std::get<std::vector<int32_t>>(array.values);
    }
    for (const auto c : corner) {
      corners.push_back(place.at(static_cast<size_t>(2 * c)));
      corners.push_back(place.at(static_cast<size_t>(2 * c + 1)));
    }
    return corners;
  };
  const Moment moment{0.25, 3, {}};
  const auto put = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  };
  put("one.vtu", encode(squares({}), moment, Compression::zlib));
  const auto one = hfrac::web::read_grid(folder / "one.vtu");
  for (const int64_t count : {2, 3, 25, 40}) {  // of 40 pieces some are empty
    std::vector<std::string> files;
    for (int64_t k = 0; k < count; ++k) {
      files.push_back("piece_" + std::to_string(k) + ".vtu");
      put(files.back(), encode(squares({k, count}), moment, Compression::zlib));
    }
    put("list.pvtu", encode_list(squares({0, count}), files, Compression::zlib));
    const auto read = hfrac::web::read_grid(folder / "list.pvtu");
    EXPECT_EQ(read->time, 0.25);
    ASSERT_EQ(read->cells, one->cells) << count;
    EXPECT_EQ(corners_of(*read), corners_of(*one)) << count;
    const vtkNew<vtkXMLPUnstructuredGridReader> reader;
    reader->SetFileName((folder / "list.pvtu").c_str());
    reader->Update();
    auto* by_vtk = reader->GetOutput();
    ASSERT_EQ(by_vtk->GetNumberOfCells(), one->cells) << count;
    for (vtkIdType c = 0; c < by_vtk->GetNumberOfCells(); ++c)
      EXPECT_EQ(by_vtk->GetCellData()->GetArray("number")->GetComponent(c, 0), static_cast<double>(c));
  }
  fs::remove(folder / "piece_17.vtu");
  EXPECT_THROW(hfrac::web::read_grid(folder / "list.pvtu"), ReadError);
  fs::remove_all(folder);
}

// One block of an array is 2^17 bytes: none, one, one exactly full, several.
INSTANTIATE_TEST_SUITE_P(Codings, Writer,
                         testing::Combine(testing::Values(Compression::zlib, Compression::lz4,
                                                          Compression::none),
                                          testing::Values(0, 1, 32768, 40000)));

}  // namespace
