// SPDX-License-Identifier: MIT-0
// Which methods have a card.
std::vector<Card> every_card() {
  return {
      any("euler", euler),
  };
}
