#include <string>

#include <nlohmann/json.hpp>

#include <QtTest>

#include "sim2d/base/JsonText.h"

using nlohmann::json;

class JsonTextTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shallowJson_validText_isUnchanged() {
    const std::string nested = std::string(200, '[') + std::string(200, ']');
    for (const std::string& text :
         {std::string(), std::string("{\"a\": [1, {\"b\": \"x\"}], \"c\": \"[\"}"), nested,
          "{\"text\": \"" + std::string(1000, '{') + "\", \"quoted\": \"\\\"[[[\\\\\"}",
          std::string("[[{\"k\": []}],[]]")}) {
      QCOMPARE(base::shallowJson(text), std::string_view(text));
    }
  }

  void shallowJson_manySiblings_areUnchanged() {
    std::string text = "[";
    for (int i = 0; i < 1000; ++i) {
      text += "[{}],";
    }
    text += "0]";
    QCOMPARE(base::shallowJson(text), std::string_view(text));
  }

  void shallowJson_deepText_isCutAndNotValid() {
    for (const std::size_t depth : {std::size_t{201}, std::size_t{1000000}}) {
      const std::string lists = std::string(depth, '[') + std::string(depth, ']');
      QCOMPARE(base::shallowJson(lists), std::string_view(lists).substr(0, 200));
      std::string objects;
      for (std::size_t i = 0; i < depth; ++i) {
        objects += "{\"k\":";
      }
      objects += "0" + std::string(depth, '}');
      QVERIFY(json::parse(base::shallowJson(objects), nullptr, false).is_discarded());
    }
  }
};

QTEST_GUILESS_MAIN(JsonTextTest)
#include "tst_JsonText.moc"
