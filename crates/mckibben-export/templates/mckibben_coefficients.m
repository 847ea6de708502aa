function [c, slope, integral, muscle] = mckibben_coefficients(contraction)
% MCKIBBEN_COEFFICIENTS  What the functions of this folder need: c, dc/de and the integral of c at contractions.
% @{facts}
node = @{m_nodes};
muscle = struct('length', @{length}, 'supply', @{supply}, 'low', node(1), 'high', node(end), 'v', @{m_v}, 'friction', @{m_friction});
a = @{m_a};
b = @{m_b};
inside = min(max(contraction, muscle.low), muscle.high);
beyond = contraction - inside;
n = ones(size(inside));
for k = 2:numel(node) - 1
    n = n + (inside >= node(k));
end
pick = @(values, k) reshape(values(k), size(inside));
left = pick(node, n);
h = pick(node, n + 1) - left;
t = (inside - left) ./ h;
s = 1 - t;
w = {(1 + 2 * t) .* s .^ 2, h .* t .* s .^ 2, t .^ 2 .* (3 - 2 * t), -h .* t .^ 2 .* s};
d = {-6 * t .* s ./ h, s .* (1 - 3 * t), 6 * t .* s ./ h, t .* (3 * t - 2)};
g = {h .* (t - t .^ 3 + t .^ 4 / 2), h .^ 2 .* (t .^ 2 / 2 - 2 / 3 * t .^ 3 + t .^ 4 / 4), h .* (t .^ 3 - t .^ 4 / 2), h .^ 2 .* (t .^ 4 / 4 - t .^ 3 / 3)};
c = cell(1, 5); slope = c; integral = c;
for i = 1:5
    ai = a(i, :); bi = b(i, :); width = diff(node);
    sums = [0, cumsum(width / 2 .* (ai(1:end - 1) + ai(2:end) + width / 6 .* (bi(1:end - 1) - bi(2:end))))];
    sum4 = @(x) x{1} .* pick(ai, n) + x{2} .* pick(bi, n) + x{3} .* pick(ai, n + 1) + x{4} .* pick(bi, n + 1);
    ci = sum4(w); si = sum4(d);
    integral{i} = pick(sums, n) + sum4(g) + beyond .* (ci + 0.5 * si .* beyond);
    c{i} = ci + si .* beyond;
    slope{i} = si;
end
end
