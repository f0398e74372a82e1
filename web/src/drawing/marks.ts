// Of Observable Plot what the charts are drawn with.
export {
  areaY, axisX, axisY, dot, frame, gridX, gridY, line, plot, rect, ruleX, ruleY, text,
} from '@observablehq/plot';
