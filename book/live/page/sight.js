// What is in sight.
(function () {
  'use strict';
  const Live = (globalThis.Live ??= {});

  // Tells whether an element is in sight, and whether most of what could be seen of it is.
  Live.watch = function (element, told) {
    new IntersectionObserver(
      entries => {
        const { isIntersecting, boundingClientRect, rootBounds, intersectionRect } = entries.at(-1);
        const most = 0.6 * Math.min(boundingClientRect.height, rootBounds?.height ?? Infinity);
        told(isIntersecting, intersectionRect.height > most);
      },
      { threshold: [0, 0.2, 0.35, 0.5, 0.65, 0.8] },
    ).observe(element);
  };
})();
