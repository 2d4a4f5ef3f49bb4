#include <QtTest>

#include "sim2d/base/Lexer.h"
#include "tests/support/Columns.h"

using base::LexerRules;
using base::Token;

namespace {

const LexerRules kAll = {{"..", "<=", "<", "+", "-"}, "@", ".", true, true, false};
const LexerRules kPlain = {{"<=", "<", "-"}, "", ".", false, false, true};

/// "N:1.5 S:<= ?:$".
QString told(const std::vector<Token>& tokens) {
  QStringList words;
  for (const Token& token : tokens) {
    if (token.kind == Token::Kind::Number) {
      words += QStringLiteral("number:") + QString::number(token.number);
      continue;
    }
    const char* const kind = token.kind == Token::Kind::Text   ? "text:"
                             : token.kind == Token::Kind::Name ? "name:"
                             : token.kind == Token::Kind::Sign ? "sign:"
                             : token.kind == Token::Kind::End  ? "end"
                                                               : "unreadable:";
    words += QString::fromUtf8(kind) + QString::fromStdString(token.text);
  }
  return words.join(QLatin1Char(' '));
}

}  // namespace

/// The languages that use it have their own tests: tst_Scripts, tst_Expression.
class LexerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tokensOf_words_kindsAndTexts_data() {
    addColumns<bool, QString, QString>({"isPlain", "source", "expected"});
    const auto row = [](bool isPlain, const char* source, const char* expected) {
      QTest::newRow(source) << isPlain << QString::fromUtf8(source) << QString::fromUtf8(expected);
    };
    row(false, "", "end");
    row(false, "a<=1", "name:a sign:<= number:1 end");
    row(false, "1..2", "number:1 sign:.. number:2 end");
    row(false, ".5 1.5e-3 2e+1", "number:0.5 number:0.0015 number:20 end");
    row(false, "0x1F 0X10", "number:31 number:16 end");
    row(false, "0x", "unreadable:0x end");
    row(false, "'it''s'", "text:it text:s end");
    row(false, "'open", "unreadable:'open end");
    row(false, "@key p.x", "name:@key name:p.x end");
    row(false, "1a 1e", "unreadable:1 name:a unreadable:1e end");
    row(false, "1.2.3", "unreadable:1.2.3 end");
    row(true, "2and 0x1", "number:2 name:and number:0 name:x1 end");
    row(true, "1..2 .", "unreadable:1..2 unreadable:. end");
    row(true, "'a' $", "unreadable:' name:a unreadable:' unreadable:$ end");
    row(true, "1-2e-3", "number:1 sign:- number:0.002 end");
  }

  void tokensOf_words_kindsAndTexts() {
    QFETCH(bool, isPlain);
    QFETCH(QString, source);
    QFETCH(QString, expected);
    QCOMPARE(told(base::tokenize(source.toStdString(), isPlain ? kPlain : kAll)), expected);
  }

  void tokensOf_columns_countFromOne() {
    const std::vector<Token> tokens = base::tokenize("ab  <= 'x'", kAll);
    QCOMPARE(tokens.size(), std::size_t{4});
    QCOMPARE(tokens[0].column, 1);
    QCOMPARE(tokens[1].column, 5);
    QCOMPARE(tokens[2].column, 8);
    QCOMPARE(tokens[3].column, 11);
  }
};

QTEST_APPLESS_MAIN(LexerTest)
#include "tst_Lexer.moc"
