// Text of doc comments, in which simple formulas are typed as a C++ programmer types them: x'' = -omega^2 x.
import { escapeHtml, smarten } from './text.mjs';

export function docTextHtml(text, before) {
  const signs = text
    .replace(/(?<![\w'"])([A-Za-z](?:_[a-z])?)(''?)(?![\w'])/g, (_, name, primes) => name + '′″'[primes.length - 1])
    .replace(/(?<=[\w)|′″]) - (?=[\w(|])/g, ' − ')
    .replace(/(?<=^|[\s([/^])-(?=[\w(|])/g, '−')
    .replace(/(?<=[\w)|′″])( ?)\*\1(?=[\w(|])/g, '$1·$1')
    .replace(/<=/g, '≤')
    .replace(/>=/g, '≥');
  return escapeHtml(smarten(signs, before))
    .replace(/&quot;/g, '"')
    .replace(/(?<=[\p{L}\p{N})|′″])\^(−?\d+|[a-z]\b)/gu, '<sup>$1</sup>');
}
