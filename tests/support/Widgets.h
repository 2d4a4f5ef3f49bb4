#pragma once

#include <algorithm>

#include <QtWidgets>

/// Widgets of a panel or window, found as a user recognizes them. Null: there is none.
namespace widgets {

/// The first one of a kind that satisfies the condition.
template <class Widget, class Condition>
Widget* findIf(const QObject& in, Condition condition) {
  const QList<Widget*> all = in.findChildren<Widget*>();
  const auto found = std::find_if(all.begin(), all.end(), condition);
  return found == all.end() ? nullptr : *found;
}

/// By the name that screen readers read.
template <class Widget>
Widget* named(const QObject& in, const QString& name) {
  return findIf<Widget>(in, [&](const Widget* each) { return each->accessibleName() == name; });
}

template <class Widget>
Widget* withText(const QObject& in, const QString& text) {
  return findIf<Widget>(in, [&](const Widget* each) { return each->text() == text; });
}

/// A section of a form, by its heading.
template <class Section>
Section* titled(const QObject& in, const QString& title) {
  return findIf<Section>(in, [&](const Section* each) { return each->title() == title; });
}

/// An open menu or dialog, or another widget that is shown.
template <class Widget>
Widget* shown(const QObject& in) {
  return findIf<Widget>(in, [](const Widget* each) { return each->isVisible(); });
}

}  // namespace widgets
