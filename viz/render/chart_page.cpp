// SPDX-License-Identifier: BSD-3-Clause
#include "chart_page.h"

#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPDFExporter.h>
#include <vtkSVGExporter.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chart_panel.h"
#include "fonts.h"
#include "shape_item.h"

namespace hfrac::viz {
namespace {

constexpr int text_resolution = 72;  // one point of a font is one drawn pixel

}  // namespace

ChartPage::ChartPage(OffscreenWindow* window, double page_height, double pixels)
    : window_(window),
      height_(page_height),
      pixels_(pixels),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      actor_(vtkSmartPointer<vtkContextActor>::New()),
      sheet_(vtkSmartPointer<vtkContextTransform>::New()),
      shapes_(vtkSmartPointer<ShapeItem>::New()) {
  window_->SetNumberOfLayers(1);
  window_->SetSize(static_cast<int>(std::lround(width * pixels)),
                   static_cast<int>(std::lround(page_height * pixels)));
  const Colour paper = palette().paper;
  renderer_->SetBackground(paper.red / 255.0, paper.green / 255.0, paper.blue / 255.0);
  renderer_->AddActor(actor_);
  actor_->GetScene()->SetRenderer(renderer_);
  actor_->GetScene()->AddItem(sheet_);
  window_->AddRenderer(renderer_);
}

ChartPage::~ChartPage() {
  window_->RemoveRenderer(renderer_);
}

std::vector<Point> ChartPage::placed(const std::vector<Point>& points) const {
  std::vector<Point> drawn;
  drawn.reserve(points.size());
  for (const Point& point : points) drawn.push_back({point.x * pixels_, (height_ - point.y) * pixels_});
  return drawn;
}

void ChartPage::line(const std::vector<Point>& points, double thickness, Colour colour) {
  if (points.size() > 1) shapes_->add_line(placed(points), thickness * pixels_, colour);
}

void ChartPage::polygon(const std::vector<Point>& corners, Colour fill) {
  shapes_->add_polygon(placed(corners), fill);
}

void ChartPage::dot(Point centre, double radius, Colour colour) {
  constexpr int corner_count = 24;
  std::vector<Point> corners;
  for (int i = 0; i < corner_count; ++i) {
    const double angle = 2 * std::numbers::pi * i / corner_count;
    corners.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  polygon(corners, colour);
}

void ChartPage::text(double x, double y, const std::string& content, const TextStyle& style) {
  if (content.empty()) return;
  auto property = vtkSmartPointer<vtkTextProperty>::New();
  set_font(property, style.bold, style.size * pixels_, style.colour);
  property->SetVerticalJustificationToBottom();
  if (style.align == Align::centre) property->SetJustificationToCentered();
  if (style.align == Align::right) property->SetJustificationToRight();
  if (style.upwards) property->SetOrientation(90.0);
  shapes_->add_text({x * pixels_, (height_ - y) * pixels_}, content, property);
}

double ChartPage::text_width(const std::string& content, const TextStyle& style) const {
  vtkNew<vtkTextProperty> property;
  set_font(property, style.bold, style.size * pixels_, style.colour);
  int bounds[4] = {0, 0, 0, 0};
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (content.empty() || renderer == nullptr ||
      !renderer->GetBoundingBox(property, content, bounds, text_resolution)) {
    return 0.6 * style.size * static_cast<double>(content.size());
  }
  return (bounds[1] - bounds[0] + 1) / pixels_;
}

void ChartPage::panel(const Box& box, const Panel& panel) {
  const Box drawn = {box.left * pixels_, (height_ - box.bottom()) * pixels_, box.width * pixels_,
                     box.height * pixels_};
  const PanelRanges ranges = ranges_of(panel);
  const PanelTicks ticks = ticks_of(panel, ranges, box.width, box.height);
  sheet_->AddItem(make_chart(drawn, ranges, ticks, pixels_));
  put_grid(box, ranges, ticks);
  put_curves(box, panel, ranges);
  put_names(box, panel);
}

// Faint lines at the ticks, but where an axis is.
void ChartPage::put_grid(const Box& box, const PanelRanges& ranges, const PanelTicks& ticks) {
  constexpr double thickness = 1.2;
  const auto apart = [](double share) { return share > 1e-3 && share < 1 + 1e-9; };
  for (const Tick& tick : ticks.x) {
    const double x = box.left + box.width * ranges.x.share(tick.value);
    if (apart(ranges.x.share(tick.value)))
      line({{x, box.bottom() - 1}, {x, box.top}}, thickness, palette().grid);
  }
  for (const Tick& tick : ticks.left) {
    const double y = box.bottom() - box.height * ranges.left.share(tick.value);
    if (apart(ranges.left.share(tick.value)))
      line({{box.left + 1, y}, {box.right(), y}}, thickness, palette().grid);
  }
}

// Error bars, or the band they would make, below the curve itself.
void ChartPage::put_spread(const Box& box, const Panel& panel, const ChartSeries& series,
                           const PanelRanges& ranges) {
  ChartSeries low = series;
  ChartSeries high = series;
  for (std::size_t i = 0; i < series.spread.size() && i < series.y.size(); ++i) {
    const double half = std::isfinite(series.spread[i]) ? series.spread[i] : 0.0;
    low.y[i] -= half;
    high.y[i] += half;
  }
  low.dots = high.dots = true;  // every point, none left out
  const auto on_page = [&](const ChartSeries& edge) {
    std::vector<Point> points = curve_of(panel, edge, ranges);
    for (Point& point : points) point = {box.left + box.width * point.x, box.bottom() - box.height * point.y};
    return points;
  };
  const std::vector<Point> lower = on_page(low);
  const std::vector<Point> upper = on_page(high);
  if (lower.size() != upper.size()) return;
  if (series.banded) {
    // Slices between neighbours: a band may cross itself nowhere, but need not be convex.
    const Colour fill = mixed(series.colour, palette().paper, 0.82);
    for (std::size_t i = 1; i < lower.size(); ++i)
      polygon({lower[i - 1], lower[i], upper[i], upper[i - 1]}, fill);
    return;
  }
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if (!(lower[i].y > upper[i].y)) continue;
    line({lower[i], upper[i]}, 2, series.colour);
    for (const Point& end : {lower[i], upper[i]})
      line({{end.x - 7, end.y}, {end.x + 7, end.y}}, 2, series.colour);
  }
}

void ChartPage::put_curves(const Box& box, const Panel& panel, const PanelRanges& ranges) {
  for (const ChartSeries& series : panel.series) {
    if (!series.spread.empty()) put_spread(box, panel, series, ranges);
  }
  for (const ChartSeries& series : panel.series) {
    std::vector<Point> points = curve_of(panel, series, ranges);
    for (Point& point : points) {
      point = {box.left + box.width * point.x, box.bottom() - box.height * point.y};
      if (series.dots) dot(point, series.dot_radius, series.colour);
    }
    if (!series.dots) line(points, 2.8, series.colour);
  }
}

// The names of the series take the place of a legend: each in its colour, above the plot, where nothing lies
// below them. The unit stands there too: with the title, or with each name if there are two axes.
void ChartPage::put_names(const Box& box, const Panel& panel) {
  const bool two_axes = std::any_of(panel.series.begin(), panel.series.end(),
                                    [](const ChartSeries& series) { return series.right; });
  const bool named = std::any_of(panel.series.begin(), panel.series.end(),
                                 [](const ChartSeries& series) { return !series.name.empty(); });
  const TextStyle title{23, palette().ink, true};
  const double title_y = box.top - (named ? 50 : 20);
  text(box.left, title_y, panel.title, title);
  std::string unit = panel.unit;
  if (unit.empty() && !two_axes && !panel.series.empty()) unit = panel.series.front().unit;
  text(box.left + text_width(panel.title, title) + 12, title_y, unit, {20, palette().faint_ink});
  text(box.left + box.width / 2, box.bottom() + 62, panel.x_label, {20, palette().ink, false, Align::centre});
  double x = box.left;
  for (const ChartSeries& series : panel.series) {
    if (series.name.empty()) continue;
    const TextStyle style{18, palette().ink};
    const double y = box.top - 18;
    polygon({{x, y - 12}, {x + 22, y - 12}, {x + 22, y - 7}, {x, y - 7}}, series.colour);
    const std::string name =
        two_axes ? series.name + (series.right ? " (right, " : " (left, ") + series.unit + ")" : series.name;
    text(x + 30, y, name, style);
    x += 30 + text_width(name, style) + 28;
  }
}

void ChartPage::render() {
  if (shapes_->GetScene() == nullptr) sheet_->AddItem(shapes_);  // last: over the charts
  window_->SetDPI(text_resolution);
  window_->Render();
}

Image ChartPage::draw(int factor) {
  const int* size = window_->GetSize();
  Image image =
      drawn_in_bands(window_, size[0] / factor, size[1] / factor, factor, [&](const PageBand& band) {
        sheet_->Identity();
        sheet_->Translate(0.0F, static_cast<float>(-band.bottom * factor));
        render();
      });
  sheet_->Identity();
  return image;
}

void ChartPage::write_svg(const std::filesystem::path& path, const std::string& title) {
  render();
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window_);
  exporter->SetActiveRenderer(renderer_);
  exporter->SetFileName(path.c_str());
  exporter->SetTitle(title.c_str());
  exporter->SetDescription("Made by hfrac");
  exporter->Write();
}

void ChartPage::write_pdf(const std::filesystem::path& path, const std::string& title) {
  render();
  vtkNew<vtkPDFExporter> exporter;
  exporter->SetRenderWindow(window_);
  exporter->SetActiveRenderer(renderer_);
  exporter->SetFileName(path.c_str());
  exporter->SetTitle(title.c_str());
  exporter->Write();
}

}  // namespace hfrac::viz
