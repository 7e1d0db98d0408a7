// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Figures that came with their data become interactive: the pointer or the arrow keys name a point, the wheel and
// dragging change what is seen, a button switches both axes between linear and logarithmic. Drawn by Chart.js; without
// it the pictures stay.

const figures = {
  /** The numbers as text: four digits are what a measurement has. */
  show(value) {
    return Math.abs(value) >= 1e4 || (value !== 0 && Math.abs(value) < 1e-3) ? value.toExponential(2)
      : String(Number(value.toPrecision(4)));
  },

  dataset(curve) {
    const least = new Set(curve.least ?? []);
    return {
      label: curve.title,
      data: curve.points.map(([x, y], i) => ({x, y, name: curve.names?.[i], isLeast: least.has(i)})),
      showLine: Boolean(curve.line),
      borderColor: curve.color,
      backgroundColor: curve.color,
      borderWidth: 2,
      pointRadius: curve.dots ? 2 + 2 * curve.dots : 0,
      pointHitRadius: 8,
      pointHoverRadius: 6,
      pointStyle: (context) => (context.raw?.isLeast ? 'triangle' : 'circle'),
    };
  },

  /** What stands above the scale, as text. */
  highPoints(plot) {
    if (!(plot.most > 0)) return '';
    const high = plot.curves.flatMap((curve) => curve.points.filter(([, y]) => y > plot.most)
      .map(([x, y]) => `${curve.title} ${figures.show(y)} at ${plot.x} ${figures.show(x)}`));
    return high.length > 0 ? `above: ${high.join(', ')}` : '';
  },

  /** `most`: what is higher is seen by zooming out, or on a logarithmic axis. */
  axis(title, logarithmic, most) {
    return {
      ...(most > 0 && !logarithmic ? {max: most} : {}),
      type: logarithmic ? 'logarithmic' : 'linear',
      beginAtZero: !logarithmic,
      title: {display: true, text: title},
      ticks: {maxTicksLimit: 8, callback: (value) => figures.show(value)},
    };
  },

  make(plot, canvas) {
    return new Chart(canvas, {
      type: 'scatter',
      data: {datasets: plot.curves.map(figures.dataset)},
      options: {
        animation: false,
        aspectRatio: 1.55,
        interaction: {mode: 'nearest', intersect: false},
        scales: {x: figures.axis(plot.x, plot.logarithmic), y: figures.axis(plot.y, plot.logarithmic, plot.most)},
        plugins: {
          title: {display: figures.highPoints(plot) !== '', text: figures.highPoints(plot), padding: 4, font: {weight: 'normal'}},
          legend: {labels: {usePointStyle: true, filter: (item) => item.text !== ''}},
          tooltip: {
            callbacks: {
              label: ({raw, dataset}) =>
                `${raw.name ?? dataset.label}: ${figures.show(raw.x)}, ${raw.isLeast ? '≥ ' : ''}${figures.show(raw.y)}`,
            },
          },
        },
      },
    });
  },

  /** Moves and scales what an axis shows: by `factor` about the share `at` of its length, then on by `shift` of it. */
  range(scale, factor, at, shift) {
    const isLog = scale.type === 'logarithmic';
    const to = isLog ? Math.log10 : Number;
    const from = isLog ? (value) => 10 ** value : Number;
    const low = to(scale.min), high = to(scale.max), length = high - low;
    const begin = low + length * (at * (1 - factor) + shift);
    scale.options.min = from(begin);
    scale.options.max = from(begin + length * factor);
  },

  shares(chart, event) {
    const box = chart.canvas.getBoundingClientRect(), area = chart.chartArea;
    return {
      x: (event.clientX - box.left - area.left) / (area.right - area.left),
      y: (area.bottom - event.clientY + box.top) / (area.bottom - area.top),
    };
  },

  listen(chart, canvas) {
    canvas.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && document.activeElement !== canvas) return;  // the page scrolls until the figure is chosen
      event.preventDefault();
      const at = figures.shares(chart, event), factor = event.deltaY < 0 ? 0.8 : 1.25;
      figures.range(chart.scales.x, factor, at.x, 0);
      figures.range(chart.scales.y, factor, at.y, 0);
      chart.update();
    }, {passive: false});
    let last = null;
    canvas.addEventListener('pointerdown', (event) => {
      last = figures.shares(chart, event);
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (last === null) return;
      const now = figures.shares(chart, event);
      figures.range(chart.scales.x, 1, 0, last.x - now.x);
      figures.range(chart.scales.y, 1, 0, last.y - now.y);
      last = now;
      chart.update();
    });
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { last = null; });
    canvas.addEventListener('dblclick', () => figures.reset(chart));
    canvas.addEventListener('keydown', (event) => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (event.key === '+' || event.key === '-') {
        for (const axis of ['x', 'y']) figures.range(chart.scales[axis], event.key === '+' ? 0.8 : 1.25, 0.5, 0);
        chart.update();
      } else if (event.key === '0') {
        figures.reset(chart);
      } else if (step !== undefined) {
        figures.choose(chart, step);
      } else {
        return;
      }
      event.preventDefault();
    });
  },

  reset(chart) {
    for (const scale of Object.values(chart.scales)) {
      delete scale.options.min;
      delete scale.options.max;
    }
    chart.update();
  },

  /** The next or previous point from left to right gets the tooltip. */
  choose(chart, step) {
    const points = chart.data.datasets.flatMap((dataset, datasetIndex) =>
      dataset.data.map((point, index) => ({datasetIndex, index, x: point.x})));
    points.sort((a, b) => a.x - b.x);
    chart.chosen = ((chart.chosen ?? (step > 0 ? -1 : 0)) + step + points.length) % points.length;
    const active = [points[chart.chosen]];
    const {x, y} = chart.getDatasetMeta(active[0].datasetIndex).data[active[0].index];
    chart.setActiveElements(active);
    chart.tooltip.setActiveElements(active, {x, y});
    chart.update();
  },

  /** Whether all numbers can stand on a logarithmic axis. */
  isPositive(plot) {
    return plot.curves.every((curve) => curve.points.every(([x, y]) => x > 0 && y > 0));
  },

  upgrade(image, plot) {
    const box = document.createElement('div');
    box.className = 'chart';
    const canvas = document.createElement('canvas');
    canvas.className = 'plot';
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', `${image.alt}. Arrow keys name the points, + and - zoom, 0 shows all.`);
    box.append(canvas);
    image.replaceWith(box);
    const chart = figures.make(plot, canvas);
    figures.listen(chart, canvas);
    if (figures.isPositive(plot)) {
      const button = document.createElement('button');
      button.type = 'button';
      const label = () => { button.textContent = chart.options.scales.y.type === 'linear' ? 'Logarithmic' : 'Linear'; };
      button.addEventListener('click', () => {
        const isLog = chart.options.scales.y.type === 'linear';
        chart.options.scales = {x: figures.axis(plot.x, isLog), y: figures.axis(plot.y, isLog, plot.most)};
        chart.update();
        label();
      });
      label();
      box.append(button);
    }
    return chart;
  },
};

if (typeof Chart !== 'undefined') {
  for (const data of document.querySelectorAll('figure > script[type="application/json"]')) {
    figures.upgrade(data.previousElementSibling, JSON.parse(data.textContent));
  }
}
