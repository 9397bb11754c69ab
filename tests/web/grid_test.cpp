// SPDX-License-Identifier: BSD-3-Clause
// VTU files become messages with the same numbers, whatever their encoding; damaged ones become a sentence.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "web/server/grid.hpp"
#include "web/server/grid_cache.hpp"
#include "web/server/guards.hpp"

namespace {

namespace fs = std::filesystem;
using namespace hfrac::web;

class Grids : public testing::Test {
 protected:
  void SetUp() override {
    vtkObject::GlobalWarningDisplayOff();
    folder_ = fs::temp_directory_path() / ("hfrac-grids-" + random_key());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /** A square and a triangle with a pressure each, points with a displacement, and a time. */
  static vtkSmartPointer<vtkUnstructuredGrid> sample(double pressure = 2.5e6) {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {2.0, 0.5}})
      points->InsertNextPoint(x, y, 0.0);
    grid->SetPoints(points);
    const vtkIdType square[] = {0, 1, 2, 3}, triangle[] = {1, 4, 2};
    grid->InsertNextCell(VTK_POLYGON, 4, square);
    grid->InsertNextCell(VTK_POLYGON, 3, triangle);
    vtkNew<vtkFloatArray> pressures;
    pressures->SetName("pressure_Pa");
    pressures->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "Pa");
    for (const double value : {pressure, -1.0}) pressures->InsertNextValue(static_cast<float>(value));
    grid->GetCellData()->AddArray(pressures);
    vtkNew<vtkFloatArray> displacement;
    displacement->SetName("displacement_m");
    displacement->SetNumberOfComponents(3);
    for (int i = 0; i < 3; ++i) displacement->SetComponentName(i, i == 0 ? "x" : i == 1 ? "y" : "z");
    for (int i = 0; i < 5; ++i) displacement->InsertNextTuple3(i, 10 + i, 0);
    grid->GetPointData()->AddArray(displacement);
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(0.25);
    grid->GetFieldData()->AddArray(time);
    return grid;
  }

  fs::path write(const char* name, vtkUnstructuredGrid* grid, int mode, bool compressed) const {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName((folder_ / name).c_str());
    writer->SetInputData(grid);
    writer->SetDataMode(mode);
    writer->EncodeAppendedDataOff();
    if (!compressed) writer->SetCompressorTypeToNone();
    writer->Write();
    return folder_ / name;
  }

  fs::path folder_;
};

template <class Value>
const std::vector<Value>& values(const Grid& grid, const std::string& name) {
  for (const auto& array : grid.arrays)
    if (array.name == name) return std::get<std::vector<Value>>(array.values);
  throw std::runtime_error("no array " + name);
}

TEST_F(Grids, ReadTheSameInEveryEncoding) {
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    for (const bool compressed : {false, true}) {
      const auto grid = read_grid(write("a.vtu", sample(), mode, compressed));
      EXPECT_EQ(grid->points, 5);
      EXPECT_EQ(grid->cells, 2);
      EXPECT_EQ(grid->time, 0.25);
      EXPECT_EQ(values<float>(*grid, "position"), (std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1, 2, 0.5}));
      EXPECT_EQ(values<int32_t>(*grid, "first"), (std::vector<int32_t>{0, 4, 7}));
      EXPECT_EQ(values<int32_t>(*grid, "corner"), (std::vector<int32_t>{0, 1, 2, 3, 1, 4, 2}));
      EXPECT_EQ(values<float>(*grid, "pressure_Pa"), (std::vector<float>{2.5e6F, -1.0F}));
      EXPECT_EQ(values<float>(*grid, "displacement_m"),
                (std::vector<float>{0, 10, 1, 11, 2, 12, 3, 13, 4, 14}));
    }
}

TEST_F(Grids, MessagesHoldWhatTheirHeadSays) {
  const auto grid = read_grid(write("a.vtu", sample(), vtkXMLWriter::Binary, true));
  const std::string message = grid_message(*grid);
  ASSERT_EQ(message.substr(0, 4), "HFG1");
  uint32_t length = 0;
  std::memcpy(&length, message.data() + 4, sizeof length);
  ASSERT_EQ((8 + length) % 8, 0U);
  const auto head = nlohmann::json::parse(message.substr(8, length));
  EXPECT_EQ(head["cells"], 2);
  bool found = false;
  for (const auto& array : head["arrays"]) {
    EXPECT_EQ(array["offset"].get<size_t>() % 8, 0U);
    if (array["name"] != "pressure_Pa") continue;
    found = true;
    EXPECT_EQ(array["unit"], "Pa");
    EXPECT_EQ(array["type"], "f32");
    float pressure = 0;
    std::memcpy(&pressure, message.data() + 8 + length + array["offset"].get<size_t>(), sizeof pressure);
    EXPECT_EQ(pressure, 2.5e6F);
  }
  EXPECT_TRUE(found);
}

TEST_F(Grids, MessagesCanBeCutToWhatIsShown) {
  const auto grid = read_grid(write("a.vtu", sample(), vtkXMLWriter::Binary, true));
  const std::string part = grid_message(*grid, {"pressure_Pa"});
  EXPECT_NE(part.find("pressure_Pa"), std::string::npos);
  EXPECT_NE(part.find("TimeValue"), std::string::npos);
  EXPECT_GT(part.find("displacement_m"), part.find("others"));
  EXPECT_LT(part.size(), grid_message(*grid).size());
}

TEST_F(Grids, GiveTheValuesOfOneItem) {
  const auto grid = read_grid(write("a.vtu", sample(), vtkXMLWriter::Binary, true));
  const auto cell = values_of(*grid, "cells", 0);
  ASSERT_EQ(cell.size(), 1U);
  EXPECT_EQ(cell[0]["name"], "pressure_Pa");
  EXPECT_EQ(cell[0]["values"][0], 2.5e6);
  const auto point = values_of(*grid, "points", 4);
  ASSERT_EQ(point.size(), 2U);
  EXPECT_EQ(point[0]["name"], "position");
  EXPECT_EQ(point[1]["values"], (std::vector<double>{4, 14}));
  for (const int64_t wrong : {-1, 5, 1000000}) EXPECT_THROW(values_of(*grid, "points", wrong), GridError);
}

TEST_F(Grids, WithoutCellsAreGrids) {
  vtkNew<vtkUnstructuredGrid> empty;
  vtkNew<vtkDoubleArray> time;
  time->SetName("TimeValue");
  time->InsertNextValue(0);
  empty->GetFieldData()->AddArray(time);
  const auto grid = read_grid(write("empty.vtu", empty, vtkXMLWriter::Binary, true));
  EXPECT_EQ(grid->cells, 0);
  EXPECT_GT(grid_message(*grid).size(), 8U);
}

TEST_F(Grids, DamagedOnesAreASentence) {
  const auto whole = write("whole.vtu", sample(), vtkXMLWriter::Binary, true);
  std::ifstream stream(whole, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::vector<std::string> damaged = {"", "not a grid", text.substr(0, text.size() / 2),
                                            "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"/>"};
  for (const auto& content : damaged) {
    std::ofstream(folder_ / "damaged.vtu", std::ios::binary) << content;
    try {
      read_grid(folder_ / "damaged.vtu");
      FAIL() << "read without complaint: " << content.substr(0, 20);
    } catch (const GridError& error) {
      EXPECT_NE(std::string(error.what()).find("damaged.vtu"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(read_grid(folder_ / "missing.vtu"), GridError);
}

TEST_F(Grids, NoDamageEndsTheProcess) {
  for (const int mode : {vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName((folder_ / "whole.vtu").c_str());
    const auto grid = sample();
    writer->SetInputData(grid);
    writer->SetDataMode(mode);
    writer->EncodeAppendedDataOff();
    writer->Write();
    std::ifstream stream(folder_ / "whole.vtu", std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    int sentences = 0;
    for (size_t place = 0; place < whole.size(); place += 11) {
      std::string text = whole;
      text[place] = static_cast<char>(text[place] ^ (1U << place % 7));
      std::ofstream(folder_ / "bad.vtu", std::ios::binary) << text;
      try {
        for (const auto& array : read_grid(folder_ / "bad.vtu")->arrays) EXPECT_LE(array.components, 64);
      } catch (const GridError&) {
        ++sentences;
      }
    }
    EXPECT_GT(sentences, 30);
  }
}

TEST_F(Grids, AreKeptUntilTheirFileChanges) {
  const auto file = write("a.vtu", sample(), vtkXMLWriter::Binary, true);
  GridCache cache(1);  // too small for anything but the last
  const auto first = cache.get(file);
  EXPECT_EQ(cache.get(file), first);
  write("a.vtu", sample(7e6), vtkXMLWriter::Binary, true);
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(5));
  EXPECT_EQ(values<float>(*cache.get(file), "pressure_Pa")[0], 7e6F);
  const auto other = write("b.vtu", sample(), vtkXMLWriter::Binary, true);
  const auto kept = cache.get(file);
  cache.get(other);
  EXPECT_NE(cache.get(file), kept) << "the limit does not hold";
}

}  // namespace
