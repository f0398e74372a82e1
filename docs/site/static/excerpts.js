// Leaves formulas out of the excerpts that a search shows.
document.addEventListener('DOMContentLoaded', () => {
  const textOf = Search.htmlToText;
  Search.htmlToText = (text) => {
    const page = new DOMParser().parseFromString(text, 'text/html');
    for (const formula of page.querySelectorAll('.math')) formula.replaceWith('…');
    return textOf(page.documentElement.outerHTML);
  };
});
