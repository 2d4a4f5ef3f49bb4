#include "app/report/PlayerPage.h"

#include "app/report/Markup.h"
#include "app/report/PageTexts.h"
#include "app/report/RunPictures.h"
#include "app/run/DataPaths.h"

namespace report {

namespace {

constexpr double kFineStep = 0.1;  // [s] between samples of a page with one run

std::string replaced(std::string text, const std::string& hole, const std::string& by) {
  const std::size_t at = text.find(hole);
  return at == std::string::npos ? text : text.replace(at, hole.size(), by);
}

}  // namespace

std::string wholePage(const std::string& title, const std::string& body, bool withPlayer) {
  std::string page = kPageText;
  page = replaced(page, "{{title}}", escaped(title));
  page = replaced(page, "{{style}}", kStyleText);
  page = replaced(page, "{{script}}", std::string(kReportText) + (withPlayer ? kPlayerText : ""));
  return replaced(page, "{{body}}", body);  // last: it may hold anything
}

std::string playerMarkup(const std::vector<std::string>& runs) {
  std::string data;
  for (const std::string& run : runs) {
    data += (data.empty() ? "" : ",\n") + scriptSafe(run);
  }
  return "<div class=\"player\">\n<header><select aria-label=\"Run\"></select>"
         "<b>Run</b><span>&#160;</span></header>\n"
         "<canvas></canvas>\n<div class=\"controls\"><button type=\"button\" "
         "class=\"toggle\">Play</button><input type=\"range\" min=\"0\" max=\"1\" value=\"0\" "
         "aria-label=\"Time\"/><output>0</output><select aria-label=\"Speed\">"
         "<option value=\"0.5\">0.5×</option><option value=\"1\" selected=\"selected\">1×</option>"
         "<option value=\"2\">2×</option><option value=\"4\">4×</option>"
         "<option value=\"10\">10×</option></select></div>\n<ul class=\"events\"></ul>\n</div>\n"
         "<script type=\"application/json\" id=\"replays\">[" +
         data + "]</script>\n";
}

std::string playerPage(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const std::string& title) {
  const double seconds = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  const std::string body =
      element("h1", "", escaped(title)) + "\n" +
      paragraph((trace.header.humans.size() == 1
                     ? std::string("1 person")
                     : std::to_string(trace.header.humans.size()) + " people") +
                    ", " + counted(trace.header.robots.size(), "robot") + ", " +
                    numberText(seconds, 1) + " s, seed " + std::to_string(trace.header.seed) + ".",
                " class=\"lead\"") +
      playerMarkup({playerJson(trace, contacts, {title}, kFineStep)}) +
      paragraph("Made by hunavsim " + app::programVersion() + " " + app::programCommit() + ".",
                " class=\"lead\"");
  return wholePage(title, body, true);
}

}  // namespace report
