#pragma once

/// The files of resources/report, embedded by the build.
namespace report {

// HTML templates with placeholders {{name}}:
extern const char* const kPageText;        // every page
extern const char* const kRunText;         // body of the page of one run
extern const char* const kPlayerPageText;  // player
extern const char* const kStudyText;       // head of the page of a study
extern const char* const kMethodsText;     // section "Methods" of the page of a study

extern const char* const kStyleText;   // CSS
extern const char* const kReportText;  // script of every page
extern const char* const kPlayerText;  // script of the player

}  // namespace report
